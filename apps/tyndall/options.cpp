#include "options.h"

#include <charconv>

namespace tyndall::app {

Outcome<Size> parseSize(const std::string& text) {
    Size size;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    const bool split = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
    const auto height = split ? std::from_chars(width.ptr + 1, end, size.height) : width;
    const auto overflows = std::errc::result_out_of_range;
    const bool tooLong = width.ec == overflows || height.ec == overflows;
    if (!tooLong && (!split || height.ec != std::errc{} || height.ptr != end))
        return fail("--size: \"{}\" is no size; write width and height in pixels, like 640x360", text);
    if (tooLong || size.width == 0 || size.height == 0 || size.width > longestSide || size.height > longestSide)
        return fail("--size: {} is out of bounds; each side must be from 1 to {}", text, longestSide);
    return size;
}

Outcome<void> checkTechnique(const std::string& name) {
    std::string names;
    for (int bits = 7; bits >= 0; --bits) {
        const std::string_view known = techniqueName((bits & 4) != 0, (bits & 2) != 0, (bits & 1) != 0);
        if (name == known) return {};
        names += (names.empty() ? "" : ", ") + std::string(known);
    }
    return fail("--technique: slices.fx has no \"{}\"; it has {}", name, names);
}

}  // namespace tyndall::app

#include "options.h"

#include <kit/image/image.h>

#include <charconv>

namespace tyndall::app {

Result<Size> parseSize(const std::string& text) {
    Size size;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    const bool split = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
    const auto height = split ? std::from_chars(width.ptr + 1, end, size.height) : width;
    const auto overflows = std::errc::result_out_of_range;
    const bool tooLong = width.ec == overflows || height.ec == overflows;
    if (!tooLong && (!split || height.ec != std::errc{} || height.ptr != end))
        return fail("--size: \"{}\" is not a size; write width and height in pixels, like 640x360", text);
    if (tooLong || size.width == 0 || size.height == 0 || size.width > longestSide || size.height > longestSide)
        return fail("--size: {} is out of bounds; each side must be from 1 to {}", text, longestSide);
    return size;
}

Result<TermSet> parseTechnique(const std::string& name) {
    if (const auto terms = termsOf(std::string_view(name))) return *terms;
    std::string names;
    for (std::size_t i = TermSet::count; i-- > 0;)
        names += (names.empty() ? "" : ", ") + std::string(techniqueName(TermSet::fromIndex(i)));
    return fail("--technique: slices.fx has no \"{}\"; it has {}", name, names);
}

}  // namespace tyndall::app

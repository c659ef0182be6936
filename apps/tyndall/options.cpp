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

namespace {

constexpr int everyTerm = 7;

Terms termsOf(int bits) {
    return {(bits & 4) != 0, (bits & 2) != 0, (bits & 1) != 0};
}

std::string_view nameOf(const Terms& terms) {
    return techniqueName(terms.noise, terms.shadow, terms.cookie);
}

}  // namespace

std::optional<Terms> termsOf(const std::string& technique) {
    for (int bits = everyTerm; bits >= 0; --bits)
        if (technique == nameOf(termsOf(bits))) return termsOf(bits);
    return std::nullopt;
}

Outcome<void> checkTechnique(const std::string& name) {
    if (termsOf(name)) return {};
    std::string names;
    for (int bits = everyTerm; bits >= 0; --bits)
        names += (names.empty() ? "" : ", ") + std::string(nameOf(termsOf(bits)));
    return fail("--technique: slices.fx has no \"{}\"; it has {}", name, names);
}

}  // namespace tyndall::app

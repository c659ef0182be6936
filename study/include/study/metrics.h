// How far a picture is from its reference.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace tyndall::study {

/// Linear values, row 0 at the top, the channels of a pixel side by side.
struct FloatImage {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;  ///< width * height * channels
};

/// Where one value of a picture stands.
struct Place {
    int x = 0, y = 0, channel = 0;  ///< from the top left, counted from 0
};

/// Values of a picture that are no numbers to calculate with.
struct NonFinite {
    std::uint64_t nan = 0, infinite = 0;
    std::optional<Place> first;  ///< in reading order; absent where there is none
    std::uint64_t count() const { return nan + infinite; }
};

NonFinite countNonFinite(const FloatImage& image);

}  // namespace tyndall::study

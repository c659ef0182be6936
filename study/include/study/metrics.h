// How far a picture is from its reference.
#pragma once

#include <cstddef>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace tyndall::study {

/// Linear values, row 0 at the top, the channels of a pixel side by side.
struct FloatImage {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;  ///< width * height * channels
};

}  // namespace tyndall::study

// A texture as the reference reads it.
#pragma once

#include <cstddef>
#include <vector>

namespace tyndall::study {

/// Linear values, row 0 at the top, the channels of a texel side by side.
struct Texture {
    int width = 0, height = 0, channels = 0;
    std::vector<float> texels;  ///< width * height * channels

    float at(int x, int y, int channel) const {
        return texels[(static_cast<std::size_t>(y) * width + x) * channels + channel];
    }
};

}  // namespace tyndall::study

// Linear values in rows: pictures, textures and depth alike.
#pragma once

#include <cstddef>
#include <vector>

namespace tyndall::study {

/// Row 0 is the top; the channels of a pixel lie side by side.
struct Image {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;  ///< width * height * channels

    float at(int x, int y, int channel) const { return values[index(x, y, channel)]; }
    float& at(int x, int y, int channel) { return values[index(x, y, channel)]; }
    bool sameShape(const Image& other) const {
        return width == other.width && height == other.height && channels == other.channels;
    }

private:
    std::size_t index(int x, int y, int channel) const {
        return (static_cast<std::size_t>(y) * width + x) * channels + channel;
    }
};

}  // namespace tyndall::study

// Float images in memory and as files.
#pragma once

#include <tyndall/result.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tyndall::rig {

/// Linear values, row 0 at the top, the channels of a pixel side by side.
struct Image {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;  ///< width * height * channels

    float at(int x, int y, int channel) const {
        return values[(static_cast<std::size_t>(y) * width + x) * channels + channel];
    }
    float& at(int x, int y, int channel) {
        return values[(static_cast<std::size_t>(y) * width + x) * channels + channel];
    }
    bool sameShape(const Image& other) const {
        return width == other.width && height == other.height && channels == other.channels;
    }
};

/// An image without content yet: every value 0.
Image blankImage(int width, int height, int channels);

/// Any image file that OpenImageIO reads, its first part and level; integer formats become 0 to 1 as they
/// are stored, without a change of colour space. At most 16384 pixels a side and 4 channels.
Result<Image> readImage(const std::string& path);

/// OpenEXR, 32-bit float, losslessly compressed; the same image gives the same bytes. Written beside its
/// place and then renamed. NaN and infinity are kept.
Result<void> writeExr(const std::string& path, const Image& image);

/// RGB bytes, three a pixel, as a PNG. Written beside its place and then renamed.
Result<void> writePng(const std::string& path, int width, int height, const std::vector<std::uint8_t>& rgb);

}  // namespace tyndall::rig

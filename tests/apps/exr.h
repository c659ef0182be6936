// Small pictures made in code: what compare has to read, and what it has to refuse.
#pragma once

#include <OpenImageIO/imageio.h>
#include <study/metrics.h>

#include <string>

namespace tyndall::test {

/// How an OpenEXR file is laid out.
struct ExrLayout {
    OIIO::TypeDesc type = OIIO::TypeDesc::FLOAT;
    int tile = 0;            ///< pixels a side; 0: scanlines
    int parts = 1;           ///< all of them the same picture
    bool deep = false;       ///< one sample a pixel
    bool cropped = false;    ///< the display window is a pixel larger on the right
    bool mipLevels = false;  ///< tiled, with a second level of half the size that is black
};

/// A new file with this picture. With one channel it is named Y, with more R, G, B, A.
std::string writeExr(const study::FloatImage& image, const ExrLayout& layout = {},
                     const std::string& name = "picture.exr");

}  // namespace tyndall::test

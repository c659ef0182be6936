// Small pictures made in code: some that compare must read, some that it must refuse.
#pragma once

#include <OpenImageIO/imageio.h>
#include <study/metrics.h>

#include <string>
#include <vector>

namespace tyndall::test {

/// How an OpenEXR file is laid out.
struct ExrLayout {
    OIIO::TypeDesc type = OIIO::TypeDesc::FLOAT;
    int tile = 0;                            ///< pixels a side; 0: scanlines
    int parts = 1;                           ///< all of them the same picture
    bool deep = false;                       ///< one sample a pixel
    bool cropped = false;                    ///< the display window is a pixel larger on the right
    bool mipLevels = false;                  ///< tiled, with a second level of half the size that is black
    std::vector<std::string> channels = {};  ///< names; empty: Y for one channel, else R, G, B, A
};

/// A new file with this picture.
std::string writeExr(const study::Image& image, const ExrLayout& layout = {}, const std::string& name = "picture.exr");

}  // namespace tyndall::test

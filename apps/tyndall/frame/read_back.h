// Reads pictures and depths from the device.
#pragma once

#include <headless/image.h>
#include <kit/fail.h>
#include <kit/image/image.h>

#include <vector>

namespace tyndall::app {

/// A depth image's values, rows from the top. The image is in `layout` and stays in it.
Result<std::vector<float>> readDepth(const headless::Device& device, const headless::Image& depth,
                                     VkImageLayout layout);

/// Red, green and blue of an image of four 32-bit floats in layout COLOR_ATTACHMENT_OPTIMAL, which it keeps.
Result<Image> readPicture(const headless::Device& device, const headless::Image& colour);

}  // namespace tyndall::app

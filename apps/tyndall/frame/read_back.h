// Pictures and depths as they lie on the device.
#pragma once

#include <headless/image.h>
#include <kit/image/image.h>

#include <vector>

#include <kit/fail.h>

namespace tyndall::app {

/// A depth image's values, rows from the top. It is in `layout`, and stays in it.
Result<std::vector<float>> readDepth(const headless::Device& device, const headless::Image& depth,
                                      VkImageLayout layout);

/// Red, green and blue of an image of four 32-bit floats in layout COLOR_ATTACHMENT_OPTIMAL, where it stays.
Result<Image> readPicture(const headless::Device& device, const headless::Image& colour);

}  // namespace tyndall::app

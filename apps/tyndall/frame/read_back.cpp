#include "read_back.h"

#include <cstring>

namespace tyndall::app {

Result<std::vector<float>> readDepth(const headless::Device& device, const headless::Image& depth,
                                     VkImageLayout layout) {
    const auto bytes = headless::readback(device, depth, layout);
    if (!bytes) return passOn(bytes.error(), "a depth image could not be read back");
    std::vector<float> values(bytes->size() / sizeof(float));
    std::memcpy(values.data(), bytes->data(), values.size() * sizeof(float));
    return values;
}

Result<Image> readPicture(const headless::Device& device, const headless::Image& colour) {
    const auto bytes = headless::readback(device, colour, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    if (!bytes) return passOn(bytes.error(), "the picture could not be read back");
    const VkExtent2D size = colour.extent();
    Image picture = blankImage(static_cast<int>(size.width), static_cast<int>(size.height), 3);
    constexpr std::size_t stored = 4 * sizeof(float), kept = 3 * sizeof(float);
    for (std::size_t i = 0; i < pixelCount(picture); ++i)
        std::memcpy(&picture.values[3 * i], bytes->data() + stored * i, kept);
    return picture;
}

}  // namespace tyndall::app

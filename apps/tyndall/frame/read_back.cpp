#include "read_back.h"

#include <cstring>

namespace tyndall::app {

Result<std::vector<float>> readDepth(const headless::Device& device, const headless::Image& depth,
                                      VkImageLayout layout) {
    const auto bytes = headless::readback(device, depth, layout);
    if (!bytes) return fail("a depth image could not be read back: {}", bytes.error().message);
    std::vector<float> values(bytes->size() / sizeof(float));
    std::memcpy(values.data(), bytes->data(), values.size() * sizeof(float));
    return values;
}

Result<Picture> readPicture(const headless::Device& device, const headless::Image& colour) {
    const auto bytes = headless::readback(device, colour, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    if (!bytes) return fail("the picture could not be read back: {}", bytes.error().message);
    Picture picture{.width = colour.extent().width, .height = colour.extent().height, .pixels = {}};
    picture.pixels.resize(std::size_t{picture.width} * picture.height);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        std::memcpy(&picture.pixels[i], bytes->data() + 16 * i, sizeof(glm::vec3));
    return picture;
}

}  // namespace tyndall::app

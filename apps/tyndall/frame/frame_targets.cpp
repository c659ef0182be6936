#include "frame_targets.h"

#include <kit/fail.h>
#include <tyndall/renderer.h>

namespace tyndall::app {
namespace {

Result<void> make(const headless::Device& device, headless::Image& image, VkExtent2D extent, VkFormat format,
                  VkImageUsageFlags usage, std::string_view name) {
    const VkExtent2D there = image.extent();
    if (there.width == extent.width && there.height == extent.height && image.format() == format) return {};
    auto made = headless::Image::create(device, {.extent = extent, .format = format, .usage = usage, .name = name});
    if (!made) return passOn(made.error(), fmt::format("a picture of {}x{}", extent.width, extent.height));
    image = std::move(*made);
    return {};
}

}  // namespace

Result<void> fit(const headless::Device& device, FrameTargets& targets, Size size) {
    const VkExtent2D extent{size.width, size.height};
    auto colour = make(device, targets.colour, extent, colourFormat,
                       VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT, "picture");
    if (!colour) return colour;
    return make(
        device, targets.depth, extent, depthFormat,
        VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
        "scene depth");
}

Result<void> fitAccumulation(const headless::Device& device, FrameTargets& targets, const PlanOptions& options) {
    // Slices do without: the usage may cost bandwidth.
    const bool storage = options.method == Method::Raycast && (options.accumulation == Accumulation::Rgba16f ||
                                                               options.accumulation == Accumulation::Rgba32f);
    if (storage != targets.storage) targets.accumulation = {};
    targets.storage = storage;
    return make(device, targets.accumulation, targets.colour.extent(), accumulationFormat(options.accumulation),
                VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                    (storage ? VkImageUsageFlags{VK_IMAGE_USAGE_STORAGE_BIT} : 0u),
                "accumulated shafts");
}

}  // namespace tyndall::app

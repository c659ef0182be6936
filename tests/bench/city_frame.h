// A frame of the city, ready to be recorded again and again.
#pragma once

#include <headless/device.h>
#include <headless/image.h>
#include <tyndall/renderer.h>

#include "city.h"

namespace tyndall::bench {

struct CityFrame {
    headless::Image sum, colour;
    ShaftTargets targets;
    Renderer renderer;
    std::vector<LightTextures> textures;
    FrameData data;
};

/// Errors: the device cannot draw it, or has no memory for pictures of that size.
inline Result<CityFrame> cityFrame(const headless::Device& device, const City& city, VkExtent2D extent) {
    constexpr VkFormat colourFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
    auto renderer = Renderer::create({device.physicalDevice(), device.device()});
    if (!renderer) return tl::unexpected(renderer.error());
    auto sum =
        headless::Image::create(device, {.extent = extent,
                                         .format = accumulationFormat(city.options.accumulation),
                                         .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT});
    if (!sum) return tl::unexpected(sum.error());
    auto colour = headless::Image::create(
        device, {.extent = extent, .format = colourFormat, .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT});
    if (!colour) return tl::unexpected(colour.error());
    const ShaftTargets targets{.extent = extent,
                               .accumulation = sum->handle(),
                               .accumulationView = sum->view(),
                               .colour = colour->view(),
                               .colourFormat = colourFormat};
    return CityFrame{std::move(*sum),
                     std::move(*colour),
                     targets,
                     std::move(*renderer),
                     std::vector<LightTextures>(city.lights.size()),
                     FrameData{}};
}

}  // namespace tyndall::bench

#include "shadow_maps.h"

#include <headless/commands.h>

namespace tyndall::app {
namespace {

/// Those that can leave a mark in the light's map.
std::vector<Occluder> occludersOf(const Light& light, const GpuScene& gpu) {
    std::vector<Occluder> occluders;
    for (std::size_t i = 0; i < gpu.occluders.size(); ++i)
        if (mayShade(light, gpu.occluders[i], gpu.bounds[i])) occluders.push_back(gpu.occluders[i]);
    return occluders;
}

}  // namespace

Outcome<ShadowMaps> drawShadowMaps(const headless::Device& device, Renderer& renderer, FrameData& frame,
                                   std::span<const Light> lights, const GpuScene& gpu, std::uint32_t size) {
    ShadowMaps maps;
    maps.images.resize(lights.size());
    maps.views.resize(lights.size(), VK_NULL_HANDLE);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (!lights[i].shadow) continue;
        auto image =
            headless::Image::create(device, {.extent = {size, size},
                                             .format = shadowFormat,
                                             .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT |
                                                      VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                                             .name = "shadow map"});
        if (!image) return fail("--shadow-size {}: {}", size, image.error().message);
        maps.images[i] = std::move(*image);
        maps.views[i] = maps.images[i].view();
    }
    const auto time = headless::submitAndWait(device, [&](VkCommandBuffer commands) -> Result<void> {
        for (std::size_t i = 0; i < lights.size(); ++i) {
            if (maps.views[i] == VK_NULL_HANDLE) continue;
            const headless::Image& image = maps.images[i];
            headless::transition(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
            auto drawn = renderer.recordShadowMap(commands, frame, lights[i], occludersOf(lights[i], gpu), image.view(),
                                                  shadowFormat, size);
            if (!drawn) return drawn;
            headless::transition(commands, image, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        }
        return {};
    });
    if (!time) return fail("the shadow maps: {}", time.error().message);
    maps.milliseconds = *time;
    return maps;
}

}  // namespace tyndall::app

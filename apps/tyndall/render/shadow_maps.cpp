#include "shadow_maps.h"

#include <headless/commands.h>

namespace tyndall::app {
Outcome<ShadowMaps> drawShadowMaps(const headless::Device& device, Renderer& renderer, FrameData& frame,
                                   const ViewedScene& viewed, std::span<const SurfaceLight> lights, const GpuScene& gpu,
                                   std::uint32_t size) {
    ShadowMaps maps;
    maps.images.resize(lights.size());
    maps.views.resize(lights.size(), VK_NULL_HANDLE);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (!lights[i].shadowMap) continue;
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
    std::vector<Occluder> occluders;
    const auto time = headless::submitAndWait(device, [&](VkCommandBuffer commands) -> Result<void> {
        for (std::size_t i = 0; i < lights.size(); ++i) {
            if (maps.views[i] == VK_NULL_HANDLE) continue;
            const headless::Image& image = maps.images[i];
            headless::transition(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
            occluders.clear();
            for (const std::size_t instance : viewed.instancesInLight[i]) occluders.push_back(gpu.occluders[instance]);
            auto drawn = renderer.recordShadowMap(commands, frame, viewed.lights[i], occluders, image.view(),
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

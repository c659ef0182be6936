#include "drawn_scene.h"

#include <headless/commands.h>

#include <cstring>

#include "surfaces.h"
#include "used_images.h"

namespace tyndall::app {
namespace {

Outcome<headless::Image> makeTarget(const headless::Device& device, Size size, VkFormat format, VkImageUsageFlags usage,
                                    std::string_view name) {
    auto made = headless::Image::create(device, {.extent = {size.width, size.height},
                                                 .format = format,
                                                 .usage = usage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                                                 .name = name});
    if (!made) return fail("a picture of {}x{}: {}", size.width, size.height, made.error().message);
    return std::move(*made);
}

Outcome<void> drawSurfaces(const headless::Device& device, const ViewedScene& viewed,
                           std::span<const SurfaceLight> lights, std::uint32_t shadowSize, bool lit,
                           VkPipelineCache cache, DrawnScene& drawn) {
    auto pipelines = surfacePipelines(device, cache);
    if (!pipelines) return tl::unexpected(pipelines.error());
    auto pass = prepareSurfaces(device, *pipelines, colourFormat, depthFormat, viewed, lights, drawn.gpu,
                                drawn.maps.views, shadowSize, lit);
    if (!pass) return tl::unexpected(pass.error());
    const auto time = headless::submitAndWait(device, [&](VkCommandBuffer commands) -> Result<void> {
        headless::transition(commands, drawn.colour, VK_IMAGE_LAYOUT_UNDEFINED,
                             VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
        headless::transition(commands, drawn.depth, VK_IMAGE_LAYOUT_UNDEFINED,
                             VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
        auto recorded = recordSurfaces(commands, *pipelines, *pass, viewed.scene, drawn.gpu,
                                       {drawn.colour.extent(), drawn.colour.view(), drawn.depth.view()});
        headless::transition(commands, drawn.depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                             VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
        return recorded;
    });
    if (!time) return fail("the surfaces: {}", time.error().message);
    drawn.surfaces = *time;
    drawn.surfaceDraws = pass->draws.size();
    drawn.surfacePipelines = pipelines->count();
    return {};
}

}  // namespace

Outcome<DrawnScene> drawScene(const headless::Device& device, Renderer& renderer, const ViewedScene& viewed,
                              std::span<const SurfaceLight> lights, Size size, std::uint32_t shadowSize, bool lit,
                              VkPipelineCache cache) {
    DrawnScene drawn;
    auto gpu = uploadScene(device, viewed.scene);
    if (!gpu) return tl::unexpected(gpu.error());
    drawn.gpu = std::move(*gpu);
    if (auto done = uploadImages(device, viewed.scene, surfaceImages(viewed, lights, lit), drawn.gpu); !done)
        return tl::unexpected(done.error());
    auto colour = makeTarget(device, size, colourFormat, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, "picture");
    if (!colour) return tl::unexpected(colour.error());
    drawn.colour = std::move(*colour);
    auto depth = makeTarget(device, size, depthFormat,
                            VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT, "scene depth");
    if (!depth) return tl::unexpected(depth.error());
    drawn.depth = std::move(*depth);
    auto maps = drawShadowMaps(device, renderer, drawn.shadowData, viewed, lights, drawn.gpu, shadowSize);
    if (!maps) return tl::unexpected(maps.error());
    drawn.maps = std::move(*maps);
    if (auto done = drawSurfaces(device, viewed, lights, shadowSize, lit, cache, drawn); !done)
        return tl::unexpected(done.error());
    return drawn;
}

Outcome<std::vector<float>> readDepth(const headless::Device& device, const headless::Image& depth,
                                      VkImageLayout layout) {
    const auto bytes = headless::readback(device, depth, layout);
    if (!bytes) return fail("a depth image could not be read back: {}", bytes.error().message);
    std::vector<float> values(bytes->size() / sizeof(float));
    std::memcpy(values.data(), bytes->data(), values.size() * sizeof(float));
    return values;
}

}  // namespace tyndall::app

// Draws a scene's surfaces as its lights light them.
#pragma once

#include <headless/buffer.h>
#include <headless/device.h>
#include <tyndall/pass_pipelines.h>
#include <tyndall/view.h>

#include <span>
#include <vector>

#include "../command/view_scene.h"
#include "../outcome.h"
#include "../plan/surface_lights.h"
#include "gpu_scene.h"

namespace tyndall::app {

struct SurfaceTargets {
    VkExtent2D extent{};
    VkImageView colour = VK_NULL_HANDLE;  ///< cleared to black; layout COLOR_ATTACHMENT_OPTIMAL
    VkImageView depth = VK_NULL_HANDLE;   ///< cleared to 0, the far end; layout DEPTH_ATTACHMENT_OPTIMAL
};

/// What one draw reads, prepared before recording.
struct SurfaceDraw {
    PassPipeline pipeline;
    std::size_t instance = 0;
    VkDescriptorBufferInfo uniforms{};
    std::vector<NamedImage> images;
};

struct SurfacePass {
    headless::Buffer uniforms;
    std::vector<SurfaceDraw> draws;
};

/// The pipelines of scene.fx, made with `cache`, which may be null.
Outcome<PassPipelines> surfacePipelines(const headless::Device& device, VkPipelineCache cache);

/// Prepares one base draw for each instance, and one for each light that reaches the picture and the instance;
/// without `lit`, surfaces are black and only hide what is behind them. `shadowMaps` holds a view for each light, null
/// where it has none. The pipelines draw into targets of those two formats.
Outcome<SurfacePass> prepareSurfaces(const headless::Device& device, PassPipelines& pipelines, VkFormat colour,
                                     VkFormat depth, const ViewedScene& viewed, std::span<const SurfaceLight> lights,
                                     const GpuScene& gpu, std::span<const VkImageView> shadowMaps,
                                     std::uint32_t shadowSize, bool lit);

Result<void> recordSurfaces(VkCommandBuffer commands, const PassPipelines& pipelines, const SurfacePass& pass,
                            const Scene& scene, const GpuScene& gpu, const SurfaceTargets& targets);

}  // namespace tyndall::app

// Draws a scene's surfaces as its lights light them.
#pragma once

#include <headless/buffer.h>
#include <tyndall/view.h>

#include <span>
#include <vector>

#include "../scene/scene.h"
#include "gpu_scene.h"
#include "surface_pipelines.h"

namespace tyndall::app {

struct SurfaceTargets {
    VkExtent2D extent{};
    VkImageView colour = VK_NULL_HANDLE;  ///< cleared to black; layout COLOR_ATTACHMENT_OPTIMAL
    VkImageView depth = VK_NULL_HANDLE;   ///< cleared to 0, the far end; layout DEPTH_ATTACHMENT_OPTIMAL
};

/// What one draw reads, prepared before recording.
struct SurfaceDraw {
    const SurfacePipeline* pipeline = nullptr;
    std::size_t instance = 0;
    VkDescriptorBufferInfo uniforms{};
    std::vector<BoundImage> images;
};

struct SurfacePass {
    headless::Buffer uniforms;
    std::vector<SurfaceDraw> draws;
};

/// Prepares one base draw and one draw a light for each instance; without `lit`, surfaces are black and
/// only hide what is behind them. `shadowMaps` holds a view for each light, null where it has none.
Outcome<SurfacePass> prepareSurfaces(const headless::Device& device, SurfacePipelines& pipelines, const Scene& scene,
                                     const GpuScene& gpu, const View& view, std::span<const Light> lights,
                                     std::span<const VkImageView> shadowMaps, std::uint32_t shadowSize, bool lit);

void recordSurfaces(VkCommandBuffer commands, const SurfacePipelines& pipelines, const SurfacePass& pass,
                    const Scene& scene, const GpuScene& gpu, const SurfaceTargets& targets);

}  // namespace tyndall::app

// Everything that shafts are drawn from, on the device: textures, shadow maps, surfaces and their depth. The
// one place that draws them: what renders the shafts and what computes their reference start from the same.
#pragma once

#include <headless/image.h>
#include <tyndall/renderer.h>

#include "../command/view_scene.h"
#include "../plan/surface_lights.h"
#include "gpu_scene.h"
#include "shadow_maps.h"

namespace tyndall::app {

constexpr VkFormat colourFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;

struct DrawnScene {
    GpuScene gpu;  ///< with the images that surfaces call for
    ShadowMaps maps;
    headless::Image colour;  ///< of the surfaces; COLOR_ATTACHMENT_OPTIMAL
    headless::Image depth;   ///< reversed, 0 where no surface is; DEPTH_READ_ONLY_OPTIMAL
    double surfaces = 0.0;   ///< milliseconds from submission to fence
    std::size_t surfaceDraws = 0, surfacePipelines = 0;
    FrameData shadowData;  ///< what the shadow maps were drawn with
};

/// `lights` says how each of the scene's lights is to light surfaces; shadow maps are drawn for those that call for
/// one. Without `lit`, surfaces are black and only hide what is behind them. Their pipelines are made with `cache`,
/// which may be null.
Outcome<DrawnScene> drawScene(const headless::Device& device, Renderer& renderer, const ViewedScene& viewed,
                              std::span<const SurfaceLight> lights, Size size, std::uint32_t shadowSize, bool lit,
                              VkPipelineCache cache = VK_NULL_HANDLE);

/// A depth image's values, rows from the top. It is in `layout`, and stays in it.
Outcome<std::vector<float>> readDepth(const headless::Device& device, const headless::Image& depth,
                                      VkImageLayout layout);

}  // namespace tyndall::app

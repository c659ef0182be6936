// Draws a scene's lit surfaces.
#pragma once

#include <headless/buffer.h>
#include <headless/device.h>
#include <kit/fail.h>
#include <tyndall/pass_pipelines.h>
#include <tyndall/view.h>

#include <span>
#include <vector>

#include "gpu_scene.h"
#include "shadow_maps.h"
#include "surface_lights.h"
#include "view_scene.h"

namespace tyndall::app {

struct SurfaceTargets {
    VkExtent2D extent{};
    VkImageView colour = VK_NULL_HANDLE;  ///< cleared to black; layout COLOR_ATTACHMENT_OPTIMAL
    VkImageView depth = VK_NULL_HANDLE;   ///< cleared to 0, the far end; layout DEPTH_ATTACHMENT_OPTIMAL
};

/// The data of one draw, prepared before recording.
struct SurfaceDraw {
    PassPipeline pipeline;
    std::size_t instance = 0;
    VkDescriptorBufferInfo uniforms{};
    std::vector<NamedImage> images;
};

/// Grows as needed. It may be prepared again when the commands recorded with it have finished.
struct SurfacePass {
    headless::Buffer uniforms;
    std::vector<SurfaceDraw> draws;
};

struct SurfaceInputs {
    const ViewedScene& viewed;
    std::span<const SurfaceLight> lights;  ///< one for each of viewed.lights
    const ShadowMaps& maps;
    std::uint32_t shadowSize = 0;
    bool lit = true;  ///< false: surfaces are black and only occlude
};

/// The pipelines of scene.fx, made with `cache`, which may be null.
Result<PassPipelines> surfacePipelines(const headless::Device& device, VkPipelineCache cache);

/// Prepares one base draw for each instance, and one for each light that lights the instance in the picture. `gpu`
/// has the images that they need. The pipelines draw into targets of those two formats.
Result<void> prepareSurfaces(const headless::Device& device, PassPipelines& pipelines, VkFormat colour, VkFormat depth,
                             const SurfaceInputs& inputs, const GpuScene& gpu, SurfacePass& pass);

Result<void> recordSurfaces(VkCommandBuffer commands, const PassPipelines& pipelines, const SurfacePass& pass,
                            const Scene& scene, const GpuScene& gpu, const SurfaceTargets& targets);

}  // namespace tyndall::app

// The lights' shadow maps, drawn on the device.
#pragma once

#include <headless/image.h>
#include <tyndall/renderer.h>

#include <span>
#include <vector>

#include "../command/view_scene.h"
#include "../plan/surface_lights.h"
#include "gpu_scene.h"

namespace tyndall::app {

constexpr VkFormat shadowFormat = VK_FORMAT_D32_SFLOAT;

struct ShadowMaps {
    std::vector<headless::Image> images;  ///< by light, empty where it throws no shadow; SHADER_READ_ONLY_OPTIMAL
    std::vector<VkImageView> views;       ///< by light, null where it throws no shadow
    double milliseconds = 0.0;            ///< from submission to fence
};

/// A map for each light that calls for one, of what stands in its volume. `frame` must outlive the drawing, which is
/// over when this returns.
Outcome<ShadowMaps> drawShadowMaps(const headless::Device& device, Renderer& renderer, FrameData& frame,
                                   const ViewedScene& viewed, std::span<const SurfaceLight> lights, const GpuScene& gpu,
                                   std::uint32_t size);

}  // namespace tyndall::app

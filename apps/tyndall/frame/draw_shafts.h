// Draws the slices of a plan into a frame.
#pragma once

#include <headless/statistics.h>
#include <tyndall/renderer.h>

#include "frame_statistics.h"
#include "frame_targets.h"
#include "gpu_scene.h"
#include "plan_scene.h"
#include "shadow_maps.h"

namespace tyndall::app {

/// With eight bits the slices show as steps, which a blur hides.
bool isBlurred(const Plan& plan);

/// The textures of each light, by light; null if there is none on the device.
std::vector<LightTextures> texturesOf(const PlannedScene& planned, const ShadowMaps& maps, const GpuScene& gpu);

/// Draws `plan`, which `frame` holds, over targets.colour. `measure` adds the slices twice and times the
/// second, so that the time has no compilation in it. `counter` may be null.
Result<void> drawShafts(const headless::Device& device, Renderer& renderer, FrameData& frame, const Plan& plan,
                        std::span<const LightTextures> textures, const FrameTargets& targets, bool measure,
                        headless::FragmentCounter* counter, FrameStatistics& statistics);

}  // namespace tyndall::app

// The slices of a plan, drawn into a frame.
#pragma once

#include <headless/statistics.h>
#include <tyndall/renderer.h>

#include "frame_statistics.h"
#include "frame_targets.h"
#include "gpu_scene.h"
#include "plan_scene.h"
#include "shadow_maps.h"

namespace tyndall::app {

/// Eight bits leave steps between the slices, which a blur hides.
bool isBlurred(const Plan& plan);

/// What each light has to look up, by light; null where there is nothing on the device.
std::vector<LightTextures> texturesOf(const PlannedScene& planned, const ShadowMaps& maps, const GpuScene& gpu);

/// Draws `plan`, which `frame` holds, over what targets.colour shows. `measure` adds the slices twice and takes the
/// time of the second, so that no compilation is in it. `counter` may be null.
Result<void> drawShafts(const headless::Device& device, Renderer& renderer, FrameData& frame, const Plan& plan,
                         std::span<const LightTextures> textures, const FrameTargets& targets, bool measure,
                         headless::FragmentCounter* counter, FrameStatistics& statistics);

}  // namespace tyndall::app

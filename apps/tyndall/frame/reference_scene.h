// A loaded scene as the reference integrator takes it.
#pragma once

#include <headless/device.h>
#include <study/reference.h>

#include <kit/fail.h>
#include "view_options.h"
#include "view_scene.h"

namespace tyndall::app {

/// The world: triangles in world space, textures as loaded, cones as they are meant. Materials that are not
/// double-sided hide from their front alone; instances that mirror keep their front.
study::ReferenceScene idealScene(const ViewedScene& viewed, const ViewOptions& options);

/// What the renderer draws from: its shadow maps and its depth, drawn on `device` and read back, and textures
/// rounded as they are uploaded, cones baked into them.
Result<study::ReferenceScene> hardwareScene(const headless::Device& device, const ViewedScene& viewed,
                                             const ViewOptions& options, std::uint32_t shadowSize);

}  // namespace tyndall::app

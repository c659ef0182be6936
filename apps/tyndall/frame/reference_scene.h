// A loaded scene in the reference integrator's form.
#pragma once

#include <headless/device.h>
#include <kit/fail.h>
#include <study/reference.h>

#include "view_options.h"
#include "view_scene.h"

namespace tyndall::app {

/// The ideal scene: triangles in world space, textures as loaded, exact cones. Materials that are not double-sided
/// occlude from their front only; mirrored instances keep their front.
study::ReferenceScene idealScene(const ViewedScene& viewed, const ViewOptions& options);

/// The renderer's scene: its shadow maps and its depth, drawn on `device` and read back, and its textures, rounded
/// and with baked cones.
Result<study::ReferenceScene> hardwareScene(const headless::Device& device, const ViewedScene& viewed,
                                            const ViewOptions& options, std::uint32_t shadowSize);

}  // namespace tyndall::app

// The uniform block of raycast.fx for one light.
#pragma once

#include <tyndall/plan.h>
#include <tyndall/raycast_data.h>

#include "slabs/slabs.h"
#include "visibility/light_volume.h"
#include "visibility/view_pose.h"

namespace tyndall {

/// `slice`: the light's constants for slices.fx; both shaders share most of them.
RaycastConstants raycastConstants(const SliceConstants& slice, const Light& light, const View& view,
                                  const PlanOptions& options, const LightPose& pose, const LightVolume& volume,
                                  const Slabs& slabs);

}  // namespace tyndall

// The uniform block of slices.fx for one light.
#pragma once

#include <tyndall/plan.h>

#include "needs/stand_ins.h"
#include "slabs/slabs.h"
#include "visibility/light_volume.h"
#include "visibility/view_pose.h"

namespace tyndall {

/// Largest component of the light's colour: the unit of a routed target's grey value, and the divisor of its group's
/// tint, so that the strongest channel uses the whole range of the target.
double greyOf(const Light& light);

SliceConstants sliceConstants(const Light& light, const View& view, const PlanOptions& options, const LightPose& pose,
                              const LightVolume& volume, const Slabs& slabs, TermSet terms, double shadowBias,
                              const StandIns& standIns = {});

/// Every number in it is finite.
bool isFinite(const SliceConstants& constants);

/// Target value of a radiance of 1.
double targetScale(const PlanOptions& options);

}  // namespace tyndall

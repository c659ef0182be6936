// The uniform block of slices.fx for one light.
#pragma once

#include <tyndall/plan.h>

#include "visibility/light_volume.h"
#include "needs/plan_technique.h"
#include "slabs/slabs.h"
#include "visibility/view_pose.h"

namespace tyndall {

/// Largest component of the light's colour: what a routed target's grey value stands for, and what its
/// group's tint is normalised by, so that the strongest channel uses the whole range of the target.
double greyOf(const Light& light);

/// What stands in for the terms that are not drawn.
struct StandInFactors {
    glm::dvec3 cookie{1.0};
    double noise = 1.0;
};

SliceConstants sliceConstants(const Light& light, const View& view, const PlanOptions& options, const LightPose& pose,
                              const LightVolume& volume, const Slabs& slabs, const Terms& terms, double shadowBias,
                              const StandInFactors& factors = {});

/// Every number in it is finite.
bool isFinite(const SliceConstants& constants);

/// Target value of a radiance of 1.
double targetScale(const PlanOptions& options);

}  // namespace tyndall

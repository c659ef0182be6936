// What air of a direction and with extinction makes of a light, over all of it that is seen.
#pragma once

#include <tyndall/light.h>
#include <tyndall/view.h>

#include "needs/needs.h"
#include "visibility/seen_air.h"
#include "visibility/view_pose.h"

namespace tyndall {

/// Whether the light asks for the term.
bool scatters(const Light& light);

/// Bounds of phase * transmittance (see slices.fx) over the seen air. 1 for a light that does not ask for it.
///
/// The seen air lies in the section of the light's pyramid that SeenAir gives, the convex hull of eight corners. No
/// point of it is farther from the eye than a corner, and all directions from it to the eye lie in a round cone that
/// holds those of the corners, as long as that is narrower than a half space; likewise the directions from the lamp.
/// The angle by which light turns is that of both cones' axes, more or less both half angles.
FactorRange scatteringRange(const Light& light, const View& view, const LightPose& pose, const SeenAir& air);

/// The largest value of the light's phase function, at least 1: wherever it is seen from.
double phasePeak(const Light& light);

}  // namespace tyndall

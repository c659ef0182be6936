// Bounds of the scattering term, phase function times transmittance, over the seen air.
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
/// The seen air lies in the section of the light's pyramid that SeenAir gives, the convex hull of eight corners. Its
/// farthest point from the eye is a corner. All directions from it to the eye lie in a round cone that holds those of
/// the corners, provided that the cone is narrower than a half space; the same holds for the directions from the lamp.
/// The angle by which light turns is the angle between both cones' axes, plus or minus both half angles.
FactorRange scatteringRange(const Light& light, const View& view, const LightPose& pose, const SeenAir& air);

/// The maximum of the light's phase function over all directions, at least 1.
double phasePeak(const Light& light);

}  // namespace tyndall

// The radiance of the value 1 in an 8-bit accumulation target.
#pragma once

#include <tyndall/light.h>
#include <tyndall/plan.h>
#include <tyndall/view.h>

#include <span>

namespace tyndall::app {

/// An upper estimate: the brightest of a coarse grid of view rays through all lights together, without shadows,
/// with white cookies and noise 1, scaled by the part of the frustum that the ray crosses. With anisotropic
/// scattering or extinction, the grid is refined around the brightest rays, and a bound covers the directions
/// between them, because the phase function's peak is narrow. The result is positive.
double automaticRange(std::span<const Light> lights, const View& view, const PlanOptions& options);

}  // namespace tyndall::app

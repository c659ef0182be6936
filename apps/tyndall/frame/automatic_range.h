// The radiance that an 8-bit accumulation target should call 1.
#pragma once

#include <tyndall/light.h>
#include <tyndall/plan.h>
#include <tyndall/view.h>

#include <span>

namespace tyndall::app {

/// An estimate from above: the brightest of a coarse grid of view rays through all lights together, as if
/// nothing threw a shadow, every cookie were white and the noise 1, scaled by the part of the frustum that
/// the ray crosses. Where air scatters in a direction or takes light away, the grid is refined around the
/// brightest rays, and what may lie between its rays counts: the phase function's peak is narrow. At least a
/// tiny positive value.
double automaticRange(std::span<const Light> lights, const View& view, const PlanOptions& options);

}  // namespace tyndall::app

// How each lamp lights the surfaces if nothing is left out, for comparison with Planner::surfaces().
#pragma once

#include <tyndall/plan.h>

#include <span>
#include <vector>

namespace tyndall::app {

/// Every lamp, with a shadow map if any instance is in its volume.
/// `instances`: see instancesByLight().
std::vector<SurfaceLight> allLights(std::span<const Light> lights, std::span<const std::vector<std::size_t>> instances);

}  // namespace tyndall::app

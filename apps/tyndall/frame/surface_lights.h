// How each lamp lights the surfaces where nothing is left out, to compare with Planner::surfaces().
#pragma once

#include <tyndall/plan.h>

#include <span>
#include <vector>

namespace tyndall::app {

/// Every lamp, with a shadow map where anything at all stands in its volume.
/// `instances`: see instancesByLight().
std::vector<SurfaceLight> allLights(std::span<const Light> lights, std::span<const std::vector<std::size_t>> instances);

}  // namespace tyndall::app

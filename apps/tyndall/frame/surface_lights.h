// How each lamp lights the surfaces that are seen. Slices ask more of a lamp than surfaces do: air in which nothing
// scatters shows no shaft, and its lamp shines all the same.
#pragma once

#include <tyndall/light.h>
#include <tyndall/plan.h>
#include <tyndall/result.h>
#include <tyndall/surroundings.h>
#include <tyndall/view.h>

#include <span>
#include <vector>

namespace tyndall::app {

struct SurfaceLight {
    bool reaches = true;            ///< a surface in the picture
    bool shadowMap = false;         ///< something may stand between it and such a surface
    std::vector<glm::dvec4> walls;  ///< view space, keep dot(n, p) + d >= 0: no surface behind one is lit
};

/// Every lamp, with a shadow map where anything at all stands in its volume.
/// `instances`: see instancesByLight().
std::vector<SurfaceLight> allLights(std::span<const Light> lights, std::span<const std::vector<std::size_t>> instances);

/// What the view calls for: no lamp whose volume it misses, no shadow map where only walls stand in the light's way.
/// Uses the planner's memory and `plan`'s.
Result<void> neededLights(Planner& planner, std::span<const Light> lights, const View& view,
                           const Surroundings& surroundings, std::uint32_t shadowSize, Plan& plan,
                           std::vector<SurfaceLight>& needed);

}  // namespace tyndall::app

#include "surface_lights.h"

namespace tyndall::app {

std::vector<SurfaceLight> allLights(std::span<const Light> lights,
                                    std::span<const std::vector<std::size_t>> instances) {
    std::vector<SurfaceLight> all;
    for (std::size_t i = 0; i < lights.size(); ++i)
        all.push_back({true, lights[i].shadow && !instances[i].empty(), {}});
    return all;
}

Result<void> neededLights(Planner& planner, std::span<const Light> lights, const View& view,
                           const Surroundings& surroundings, std::uint32_t shadowSize, Plan& plan,
                           std::vector<SurfaceLight>& needed) {
    // A plan with one slice a light, of air that scatters, seen from the same place: what it needs, surfaces need.
    std::vector<Light> bare(lights.begin(), lights.end());
    for (Light& light : bare) {
        const bool dark = light.colour == glm::dvec3(0.0) || (light.intensity == 0.0 && light.ambient == 0.0);
        light.colour = glm::dvec3(dark ? 0.0 : 1.0);
        light.intensity = light.density = 1.0;
        light.cookie = false;
        light.noise.reset();
    }
    Surroundings known = surroundings;
    known.surveys = {};
    PlanOptions options;
    options.slices = 1;
    options.shadowMapSize = shadowSize;
    if (const auto made = planner.plan(bare, view, options, known, plan); !made)
        return tl::unexpected(made.error());
    needed.clear();
    for (const PlannedLight& light : plan.lights) {
        const auto first = plan.walls.begin() + light.firstWall;
        needed.push_back({light.drawn, light.drawn && light.terms.contains(Term::Shadow),
                          light.drawn ? std::vector(first, first + light.walls) : std::vector<glm::dvec4>{}});
    }
    return {};
}

}  // namespace tyndall::app

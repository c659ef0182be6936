#include "plan_groups.h"

#include <algorithm>

#include "slice_constants.h"

namespace tyndall {
namespace {

// The same colour at another strength, to what an 8-bit picture could ever tell apart.
bool sameTint(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::all(glm::lessThanEqual(glm::abs(a - b), glm::dvec3(1e-6)));
}

}  // namespace

void formGroups(Plan& plan, std::span<const Light> lights) {
    const bool routed = plan.accumulation == Accumulation::Rgba8Routed;
    for (std::size_t i = 0; i < plan.lights.size(); ++i) {
        PlannedLight& planned = plan.lights[i];
        if (!planned.drawn) continue;
        const glm::dvec3 tint = routed ? lights[i].colour / greyOf(lights[i]) : glm::dvec3(1.0);
        const auto group = std::find_if(plan.groups.begin(), plan.groups.end(), [&](const CompositeGroup& candidate) {
            return sameTint(glm::dvec3(candidate.tint), tint);
        });
        planned.group = static_cast<std::size_t>(group - plan.groups.begin());
        if (group == plan.groups.end()) plan.groups.push_back({glm::vec3(tint), {}});
        plan.groups[planned.group].lights.push_back(i);
    }
}

}  // namespace tyndall

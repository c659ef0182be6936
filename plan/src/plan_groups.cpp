#include "plan_groups.h"

#include <algorithm>
#include <tuple>

#include "slice_constants.h"

namespace tyndall {
namespace {

// The same tint, to within what an 8-bit picture resolves.
bool sameTint(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::all(glm::lessThanEqual(glm::abs(a - b), glm::dvec3(1e-6)));
}

std::size_t groupFor(Plan& plan, const Light& light) {
    // A black light, drawn with PlanOptions::everything, has no tint.
    const bool tinted = plan.accumulation == Accumulation::Rgba8Routed && greyOf(light) > 0.0;
    const glm::dvec3 tint = tinted ? light.colour / greyOf(light) : glm::dvec3(1.0);
    const auto group = std::find_if(plan.groups.begin(), plan.groups.end(), [&](const CompositeGroup& candidate) {
        return sameTint(glm::dvec3(candidate.tint), tint);
    });
    const auto index = static_cast<std::size_t>(group - plan.groups.begin());
    if (group == plan.groups.end()) plan.groups.push_back({glm::vec3(tint), 0, 0});
    return index;
}

}  // namespace

void formGroups(Plan& plan, std::span<const Light> lights) {
    for (PlannedPart& part : plan.parts) {
        PlannedLight& light = plan.lights[part.light];
        light.group = groupFor(plan, lights[part.light]);
        part.group = static_cast<std::uint32_t>(light.group);
    }
    std::sort(plan.parts.begin(), plan.parts.end(), [](const PlannedPart& a, const PlannedPart& b) {
        return std::tuple(a.group, a.method, techniqueName(a.terms), a.light) <
               std::tuple(b.group, b.method, techniqueName(b.terms), b.light);
    });
    for (std::size_t i = 0; i < plan.parts.size(); ++i) {
        CompositeGroup& group = plan.groups[plan.parts[i].group];
        if (group.parts++ == 0) group.firstPart = static_cast<std::uint32_t>(i);
    }
}

}  // namespace tyndall

#include "light_costs.h"

#include <tyndall/explain.h>

namespace tyndall::app {
namespace {

/// Remembers which of the plan's data was counted already.
class Once {
public:
    explicit Once(std::size_t size) : met_(size) {}

    bool operator()(std::size_t i) {
        const bool first = !met_[i];
        met_[i] = true;
        return first;
    }

private:
    std::vector<bool> met_;
};

/// The map, and with Method::Raycast its hierarchy.
std::uint64_t shadowBytes(Method method, std::uint32_t size) {
    std::uint64_t bytes = std::uint64_t{size} * size * sizeof(float);
    if (method == Method::Raycast)
        for (std::uint64_t side = shadowHierarchySide(size); side > 0; side /= 2)
            bytes += side * side * 2 * sizeof(float);
    return bytes;
}

}  // namespace

std::vector<LightCost> lightCosts(const Plan& plan, const View& view, const Size& picture, std::uint32_t shadowSize) {
    std::vector<LightCost> costs(plan.lights.size());
    Once vertex(plan.vertices.size()), index(plan.indices.size()), constants(plan.constants.size());
    for (const PlannedPart& part : plan.parts) {
        LightCost& cost = costs[part.light];
        cost.parts.push_back(expectedFragments(plan, part, view, picture.width, picture.height));
        cost.fragments += cost.parts.back();
        for (std::uint32_t i = part.firstIndex; i < part.firstIndex + part.indexCount; ++i) {
            if (index(i)) cost.geometryBytes += sizeof(plan.indices[i]);
            if (vertex(plan.indices[i])) cost.geometryBytes += sizeof(SliceVertex);
        }
        if (part.method == Method::Raycast)
            cost.geometryBytes += sizeof(RaycastConstants);
        else if (constants(part.constants))
            cost.geometryBytes += sizeof(SliceConstants);
    }
    for (std::size_t i = 0; i < costs.size(); ++i)
        if (plan.lights[i].drawn && plan.lights[i].terms.contains(Term::Shadow))
            costs[i].shadowMapBytes = shadowBytes(plan.lights[i].method, shadowSize);
    return costs;
}

LightCost sum(const std::vector<LightCost>& costs) {
    LightCost all;
    for (const LightCost& cost : costs) {
        all.fragments += cost.fragments;
        all.geometryBytes += cost.geometryBytes;
        all.shadowMapBytes += cost.shadowMapBytes;
    }
    return all;
}

}  // namespace tyndall::app

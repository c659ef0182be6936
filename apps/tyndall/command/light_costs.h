// The cost of each light of a plan.
#pragma once

#include <tyndall/plan.h>
#include <tyndall/view.h>

#include <cstdint>
#include <vector>

#include "options.h"

namespace tyndall::app {

struct LightCost {
    double fragments = 0.0;           ///< see tyndall::expectedFragments()
    std::uint64_t geometryBytes = 0;  ///< vertices, indices, constants; shared data counts for the first light
    std::uint64_t shadowMapBytes = 0;
    std::vector<double> parts;  ///< fragments of each of its parts, in the plan's order
};

/// By light; the sum is the plan's cost.
std::vector<LightCost> lightCosts(const Plan& plan, const View& view, const Size& picture, std::uint32_t shadowSize);

LightCost sum(const std::vector<LightCost>& costs);

}  // namespace tyndall::app

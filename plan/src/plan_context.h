// What stays the same for all lights of one plan.
#pragma once

#include <tyndall/plan.h>

#include <span>

#include "geometry/inline_vector.h"
#include "needs/needs.h"
#include "visibility/walls.h"

namespace tyndall {

struct PlanContext {
    const View& view;
    const PlanOptions& options;
    const Surroundings& surroundings;
    std::span<const OccluderBounds> occluders;
    std::span<const BlockerBounds> blockers;
    InlineVector<glm::dvec4, 4> sides;  ///< of the view
};

}  // namespace tyndall

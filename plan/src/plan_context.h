// What stays the same for all lights of one plan.
#pragma once

#include <tyndall/plan.h>

#include "geometry/inline_vector.h"

namespace tyndall {

struct PlanContext {
    const View& view;
    const PlanOptions& options;
    const Surroundings& surroundings;
    InlineVector<glm::dvec4, 4> sides;  ///< of the view
};

}  // namespace tyndall

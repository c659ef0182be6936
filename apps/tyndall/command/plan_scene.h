// From a file and options to a plan: what `render` and `explain` have in common.
#pragma once

#include <tyndall/plan.h>

#include "view_scene.h"

namespace tyndall::app {

struct PlannedScene : ViewedScene {
    double range = 1.0;  ///< of 8-bit targets
    Plan plan;
};

Outcome<PlannedScene> planScene(const ViewOptions& view, const ShaftOptions& shafts);

/// Plans again, for a view that now knows how deep the scene is.
Outcome<void> planAgain(PlannedScene& planned, double sceneDepth, const ViewOptions& view, const ShaftOptions& shafts);

}  // namespace tyndall::app

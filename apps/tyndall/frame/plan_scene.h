// From a file and options to a plan: what `render` and `explain` have in common.
#pragma once

#include <tyndall/plan.h>

#include "view_scene.h"
#include "scene_facts.h"
#include "surface_lights.h"

namespace tyndall::app {

struct PlannedScene : ViewedScene {
    double range = 1.0;  ///< of 8-bit targets
    SceneFacts facts;
    std::vector<SurfaceLight> surfaceLights;  ///< by updateSceneFacts()
    std::optional<DepthSurvey> depth;         ///< what the plan was made with
    double displayStep = 0.0;                 ///< as PlanOptions'
    PlanOptions options;                      ///< what the plan was made with
    Plan plan;
    Planner planner;   ///< keeps its memory, and so do the plans
    Plan surfacePlan;  ///< what surfaceLights were read off
};

/// Reads the scene and plans it, as far as that can be done before anything is drawn.
Result<PlannedScene> planScene(const ViewOptions& view, const ShaftOptions& shafts);

/// To be called once camera, lights or instances have moved: finds out what plan() may know of the scene as it stands,
/// and how its lamps light its surfaces. The depth of the frame before is forgotten.
Result<void> updateSceneFacts(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts);

/// Plans again, once the scene's depth and the display's step are known.
Result<void> replanWithDepth(PlannedScene& planned, DepthSurvey depth, double displayStep, const ViewOptions& view,
                        const ShaftOptions& shafts);

/// What the plan would be if nothing were left out.
Result<Plan> planEverything(const PlannedScene& planned, const ViewOptions& view);

}  // namespace tyndall::app

// From a file and options to a plan: what `render` and `explain` have in common.
#pragma once

#include <tyndall/plan.h>

#include "scene_facts.h"
#include "shaft_options.h"
#include "surface_lights.h"
#include "view_scene.h"

namespace tyndall::app {

struct PlannedScene : ViewedScene {
    double range = 1.0;  ///< of 8-bit targets
    SceneFacts facts;
    std::vector<SurfaceLight> surfaceLights;  ///< by updateSceneFacts()
    std::optional<DepthSurvey> depth;         ///< what the plan was made with
    double displayStep = 0.0;                 ///< as PlanOptions'
    PlanOptions options;                      ///< what the plan was made with
    Plan plan;
    Planner planner;  ///< keeps its memory, and so does the plan
};

/// Reads the scene and surveys it. Nothing is planned yet.
Result<PlannedScene> prepareScene(const ViewOptions& view);

/// Plans without the depth of the scene, where no device can draw it: no surface hides a light.
Result<void> planWithoutDepth(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts);

/// Call it when camera, lights or instances may have moved. It updates what plan() may know of the scene, and how
/// each lamp lights the surfaces. The depth of the frame before is forgotten.
Result<void> updateSceneFacts(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts);

/// Plans with the drawn depth and the display's step.
Result<void> replanWithDepth(PlannedScene& planned, DepthSurvey depth, double displayStep, const ViewOptions& view,
                              const ShaftOptions& shafts);

/// What the plan would be if nothing were left out.
Result<Plan> planEverything(const PlannedScene& planned, const ViewOptions& view);

}  // namespace tyndall::app

// From a file and options to a plan: the common part of `render` and `explain`.
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
    std::vector<SurfaceLight> surfaceLights;  ///< set by updateSceneFacts()
    std::optional<DepthSurvey> depth;         ///< used for the plan
    double displayStep = 0.0;                 ///< as PlanOptions'
    PlanOptions options;                      ///< used for the plan
    Plan plan;
    Planner planner;  ///< keeps its memory, and so does the plan
};

/// Reads the scene and surveys it. Nothing is planned yet.
Result<PlannedScene> prepareScene(const ViewOptions& view);

/// Plans without the depth of the scene, if no device can draw it: no surface hides a light.
Result<void> planWithoutDepth(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts);

/// Call it when camera, lights or instances may have moved. It updates plan()'s facts about the scene, and how each
/// lamp lights the surfaces. It discards the depth of the frame before.
Result<void> updateSceneFacts(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts);

/// Plans with the drawn depth and the display's step.
Result<void> replanWithDepth(PlannedScene& planned, DepthSurvey depth, double displayStep, const ViewOptions& view,
                             const ShaftOptions& shafts);

/// The plan with nothing left out.
Result<Plan> planEverything(const PlannedScene& planned, const ViewOptions& view);

}  // namespace tyndall::app

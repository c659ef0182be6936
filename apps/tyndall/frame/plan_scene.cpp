#include "plan_scene.h"

#include <kit/fail.h>

#include "automatic_range.h"
#include "scene_view.h"

namespace tyndall::app {
namespace {

bool eightBits(Accumulation accumulation) {
    return accumulation == Accumulation::Rgba8 || accumulation == Accumulation::Rgba8Routed;
}

PlanOptions optionsFor(const PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts) {
    PlanOptions options = shafts.plan;
    options.time = view.time;
    options.range = planned.range;
    options.pictureHeight = view.size.height;
    options.displayStep = planned.displayStep;
    return options;
}

void findRange(PlannedScene& planned, const ShaftOptions& shafts) {
    if (eightBits(shafts.plan.accumulation))
        planned.range = shafts.range ? *shafts.range : automaticRange(planned.lights, planned.view, shafts.plan);
}

Surroundings surroundingsOf(const PlannedScene& planned) {
    Surroundings known = surroundingsOf(planned.facts);
    if (planned.depth) known.depth = planned.depth->asTiles();
    return known;
}

Result<void> makePlan(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts) {
    planned.options = optionsFor(planned, view, shafts);
    const auto made =
        planned.planner.plan(planned.lights, planned.view, planned.options, surroundingsOf(planned), planned.plan);
    if (!made) return passOn(made.error(), view.scene);
    return {};
}

}  // namespace

Result<PlannedScene> prepareScene(const ViewOptions& view) {
    auto viewed = viewScene(view);
    if (!viewed) return tl::unexpected(viewed.error());
    PlannedScene planned;
    static_cast<ViewedScene&>(planned) = std::move(*viewed);
    auto facts = surveyScene(planned.scene);
    if (!facts) return passOn(facts.error(), view.scene);
    planned.facts = std::move(*facts);
    return planned;
}

Result<void> planWithoutDepth(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts) {
    findRange(planned, shafts);
    return makePlan(planned, view, shafts);
}

Result<void> updateSceneFacts(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts) {
    planned.depth.reset();
    planned.view.sceneDepth = View{}.sceneDepth;
    planned.instancesInLight = instancesByLight(planned.scene, planned.lights);
    if (auto followed = followInstances(planned.facts, planned.scene); !followed)
        return passOn(followed.error(), view.scene);
    findRange(planned, shafts);
    if (shafts.plan.everything) {
        planned.surfaceLights = allLights(planned.lights, planned.instancesInLight);
        return {};
    }
    const auto needed = planned.planner.surfaces(planned.lights, planned.view, shafts.plan.shadowMapSize,
                                                 surroundingsOf(planned.facts), planned.surfaceLights);
    if (!needed) return passOn(needed.error(), view.scene);
    return {};
}

Result<void> replanWithDepth(PlannedScene& planned, DepthSurvey depth, double displayStep, const ViewOptions& view,
                             const ShaftOptions& shafts) {
    planned.view.sceneDepth = depth.farthest;
    planned.depth = std::move(depth);
    planned.displayStep = displayStep;
    return makePlan(planned, view, shafts);
}

Result<Plan> planEverything(const PlannedScene& planned, const ViewOptions& view) {
    PlanOptions options = planned.options;
    options.everything = true;
    options.terms.reset();
    auto made = plan(planned.lights, planned.view, options, surroundingsOf(planned));
    if (!made) return passOn(made.error(), view.scene);
    return std::move(*made);
}

}  // namespace tyndall::app

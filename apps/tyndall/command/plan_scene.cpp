#include "plan_scene.h"

#include "../render/automatic_range.h"

namespace tyndall::app {
namespace {

bool eightBits(Accumulation accumulation) {
    return accumulation == Accumulation::Rgba8 || accumulation == Accumulation::Rgba8Routed;
}

Outcome<Plan> makePlan(const PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts) {
    PlanOptions options;
    options.slices = shafts.planes;
    options.geometry = shafts.geometry;
    options.accumulation = shafts.accumulation;
    options.look = shafts.look;
    options.time = view.time;
    options.range = planned.range;
    options.shadowMapSize = shafts.shadowSize;
    if (shafts.technique) options.technique = *shafts.technique;
    auto made = plan(planned.lights, planned.view, options);
    if (!made) return fail("{}: {}", view.scene, made.error().message);
    return std::move(*made);
}

}  // namespace

Outcome<PlannedScene> planScene(const ViewOptions& view, const ShaftOptions& shafts) {
    auto viewed = viewScene(view);
    if (!viewed) return tl::unexpected(viewed.error());
    PlannedScene planned{std::move(*viewed), 1.0, {}};
    if (eightBits(shafts.accumulation))
        planned.range = shafts.range ? *shafts.range : automaticRange(planned.lights, planned.view, shafts);
    auto made = makePlan(planned, view, shafts);
    if (!made) return tl::unexpected(made.error());
    planned.plan = std::move(*made);
    return planned;
}

Outcome<void> planAgain(PlannedScene& planned, double sceneDepth, const ViewOptions& view, const ShaftOptions& shafts) {
    planned.view.sceneDepth = sceneDepth;
    auto made = makePlan(planned, view, shafts);
    if (!made) return tl::unexpected(made.error());
    planned.plan = std::move(*made);
    return {};
}

}  // namespace tyndall::app

#include "plan_scene.h"

#include "../render/automatic_range.h"
#include "../render/scene_view.h"
#include "../scene/load_scene.h"

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
    auto scene = loadScene(view.scene, view.time);
    if (!scene) return tl::unexpected(scene.error());
    PlannedScene planned;
    planned.scene = std::move(*scene);
    auto camera = chooseCamera(planned.scene, view.camera);
    if (!camera) return tl::unexpected(camera.error());
    planned.camera = *camera;
    planned.view = viewFrom(**camera, view.size);
    planned.lights = callForShadows(planned.scene);
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

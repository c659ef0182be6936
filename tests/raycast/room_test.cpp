// Random rooms by raycast: the planned picture is the one without omissions, and the reference's.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>

#include "random_recipe.h"
#include "room_on_gpu.h"
#include "shot_reference.h"

namespace tyndall::test {
namespace {

// The cases are the same in every run; RC_PARAMS in the environment selects others, "seed=11 max_success=200" for one.
[[maybe_unused]] const int seeded = setenv("RC_PARAMS", "seed=7 max_success=12", 0);

Plan plannedFor(const Room& room, bool everything) {
    PlanOptions options = room.options;
    options.method = Method::Raycast;
    options.geometry = Geometry::ExactPolygons;
    options.everything = everything;
    return must(plan(room.lights, room.view, options, room.surroundings()));
}

// Each light alone: walls raise the bias of the lights that end at them.
std::vector<glm::dvec3> truthOf(const Room& room, const RoomOnGpu& drawn, const Plan& plan) {
    std::vector<glm::dvec3> sum(static_cast<std::size_t>(Room::width) * Room::height);
    for (const PlannedPart& part : plan.parts) {
        study::ReferenceScene scene;
        scene.mode = study::Mode::Hardware;
        scene.view = room.view;
        scene.width = Room::width;
        scene.height = Room::height;
        scene.time = room.options.time;
        scene.shadowBias = plan.raycasts[part.constants].shadow.w;
        scene.depth = studyTexture(room.depth);
        study::ReferenceLight& light = scene.lights.emplace_back();
        light.light = room.lights[part.light];
        if (light.light.cookie) light.cookie = studyTexture(room.slides[part.light]);
        if (light.light.noise) light.noise = studyTexture(room.dust[part.light]);
        if (light.light.shadow) light.shadowMap = studyTexture(drawn.shadowMap(part.light));
        study::ReferenceOptions options;
        options.accuracy = 1e-6;
        const auto image = study::reference(scene, options);
        if (!image) throw std::runtime_error(image.error().message);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += image->radiance[i];
    }
    return sum;
}

// Of colours: an empty picture has no alpha.
double colourDifference(const Picture& a, const Picture& b) {
    double worst = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            worst = std::max(worst, std::fabs(static_cast<double>(a.pixels[i][c]) - b.pixels[i][c]));
    return worst;
}

class RaycastRoom : public GpuTest {};

RC_GTEST_FIXTURE_PROP(RaycastRoom, PlannedForcedAndReferenceAgree, ()) {
    const Recipe recipe = *recipes();
    Room room;
    build(recipe, room);
    const RoomOnGpu drawn(room);
    const Plan plan = plannedFor(room, false);
    const Picture planned = drawn.draw(plan).picture, everything = drawn.draw(plannedFor(room, true)).picture;
    RC_ASSERT(whyNotFinite(planned) + whyNotFinite(everything) == "");
    RC_ASSERT(colourDifference(planned, everything) <= 1.0 / 1024.0);
    if (plan.parts.empty()) return;
    const bool walls = std::ranges::any_of(plan.lights, [](const PlannedLight& light) { return light.walls > 0; });
    RC_CLASSIFY(walls, "ends at a wall");
    RC_CLASSIFY(room.view.orthographic, "orthographic");
    if (walls) return;  // the reference knows no walls: its shadows leak through the bias
    const double error = relativeL2(everything, truthOf(room, drawn, plannedFor(room, true)));
    RC_LOG() << "relative L2 " << error;
    RC_ASSERT(error <= 1e-4);
}

}  // namespace
}  // namespace tyndall::test

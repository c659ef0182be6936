// Random scenes: the planned picture equals the picture without omissions.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "random_recipe.h"
#include "room_on_gpu.h"

namespace tyndall::test {
namespace {

// The cases are the same in every run; RC_PARAMS in the environment selects others.
[[maybe_unused]] const int seeded = setenv("RC_PARAMS", "seed=4 max_success=500", 0);

struct Compared {
    double difference = 0.0;  ///< largest of any channel
    int x = 0, y = 0;
    float planned = 0.0f, everything = 0.0f;
};

Compared compare(const Picture& planned, const Picture& everything) {
    Compared worst;
    for (int y = 0; y < planned.height; ++y)
        for (int x = 0; x < planned.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const float a = planned.at(x, y)[c], b = everything.at(x, y)[c];
                const double difference = std::fabs(static_cast<double>(a) - b);
                if (!(difference <= worst.difference)) worst = {difference, x, y, a, b};
            }
    return worst;
}

Plan plannedFor(const Room& room, bool everything) {
    PlanOptions options = room.options;
    options.everything = everything;
    return must(plan(room.lights, room.view, options, room.surroundings()));
}

class PlannedPicture : public GpuTest {};

RC_GTEST_FIXTURE_PROP(PlannedPicture, IsTheOneInWhichNothingIsLeftOut, ()) {
    const Recipe recipe = *recipes();
    Room room;
    build(recipe, room);
    const RoomOnGpu drawn(room);
    const Plan plan = plannedFor(room, false);
    const Picture planned = drawn.draw(plan).picture, everything = drawn.draw(plannedFor(room, true)).picture;
    RC_ASSERT(whyNotFinite(planned) + whyNotFinite(everything) == "");
    const Compared worst = compare(planned, everything);
    const auto some = [&](auto&& is) { return std::any_of(plan.lights.begin(), plan.lights.end(), is); };
    RC_CLASSIFY(some([](const PlannedLight& light) { return !light.drawn; }), "a light is not drawn");
    RC_CLASSIFY(some([](const PlannedLight& light) { return light.walls > 0; }), "ends at a wall");
    RC_CLASSIFY(some([](const PlannedLight& light) { return light.divided; }), "divided");
    RC_CLASSIFY(some([](const PlannedLight& light) { return light.verdicts[Term::Shadow] == TermVerdict::NoOccluder; }),
                "no occluder");
    RC_CLASSIFY(some([](const PlannedLight& light) { return light.verdicts[Term::Cookie] == TermVerdict::Uniform; }),
                "uniform cookie");
    RC_CLASSIFY(some([](const PlannedLight& light) { return light.verdicts[Term::Noise] == TermVerdict::Invisible; }),
                "invisible noise");
    RC_LOG() << "at " << worst.x << ", " << worst.y << ": planned " << worst.planned << ", everything "
             << worst.everything;
    RC_ASSERT(worst.difference <= 1.0 / 1024.0);
}

}  // namespace
}  // namespace tyndall::test

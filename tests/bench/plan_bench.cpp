// The CPU time of planning: a hundred slices per light, all of them in view.
#include <benchmark/benchmark.h>
#include <tyndall/plan.h>

namespace {

std::vector<tyndall::Light> hall(std::int64_t count) {
    std::vector<tyndall::Light> lights;
    for (std::int64_t i = 0; i < count; ++i) {
        tyndall::Light light;
        // Neighbouring lamps are 10 cm apart, each turned a little further, so that all slices differ.
        const double turn = 0.001 * static_cast<double>(i);
        light.worldFromLight = glm::dmat4(glm::dvec4(glm::cos(turn), 0.0, -glm::sin(turn), 0.0), {0.0, 1.0, 0.0, 0.0},
                                          {glm::sin(turn), 0.0, glm::cos(turn), 0.0},
                                          {0.1 * static_cast<double>(i % 100), 0.0, -30.0, 1.0});
        light.farPlane = 10.0;
        light.clipPlanes = {{0.0, 1.0, 0.0, 1.0}};
        lights.push_back(light);
    }
    return lights;
}

void planLights(benchmark::State& state, tyndall::Geometry geometry) {
    const std::vector<tyndall::Light> lights = hall(state.range(0));
    const tyndall::View view = tyndall::perspectiveView(glm::dmat4(1.0), 1.0, 16.0 / 9.0, 0.1, 1000.0);
    tyndall::PlanOptions options;
    options.geometry = geometry;
    std::int64_t drawn = 0;
    for (auto _ : state) {
        const tyndall::Result<tyndall::Plan> plan = tyndall::plan(lights, view, options);
        if (!plan) {
            state.SkipWithError(plan.error().message.c_str());
            break;
        }
        for (const tyndall::PlannedLight& light : plan->lights) drawn += light.drawn ? 1 : 0;
    }
    state.counters["drawn"] = benchmark::Counter(static_cast<double>(drawn), benchmark::Counter::kAvgIterations);
    state.SetItemsProcessed(state.iterations() * state.range(0) * options.slices);
}

}  // namespace

BENCHMARK_CAPTURE(planLights, polygons, tyndall::Geometry::ExactPolygons)
    ->Arg(1)
    ->Arg(100)
    ->Arg(10000)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(planLights, quads, tyndall::Geometry::StretchedQuads)
    ->Arg(1)
    ->Arg(100)
    ->Arg(10000)
    ->Unit(benchmark::kMicrosecond);

// The sample scene, rendered with every technique, against the hardware reference: slices differ from it only by their
// number, rays by the rounding of floats.
#include <gtest/gtest.h>
#include <headless/device.h>
#include <study/metrics.h>
#include <tyndall/frame/plan_scene.h>
#include <tyndall/frame/reference_scene.h>
#include <tyndall/frame/scene_renderer.h>

#include <cmath>

#include "must.h"

namespace tyndall::test {
namespace {

using namespace tyndall::app;

constexpr int scenesWidth = 64, scenesHeight = 36;

ViewOptions sampleView() {
    ViewOptions view;
    view.scene = TYNDALL_SCENES "/window.glb";
    view.size = {scenesWidth, scenesHeight};
    view.layer = Layer::Shafts;
    return view;
}

Image rendered(const headless::Device& device, TermSet terms, Method method, int slices = 1) {
    ShaftOptions shafts;
    shafts.plan.method = method;
    shafts.plan.terms = terms;
    shafts.plan.accumulation = Accumulation::Rgba32f;
    shafts.plan.slices = slices;
    shafts.plan.spacing = Spacing::Even;
    PlannedScene planned = must(prepareScene(sampleView()));
    const Frame frame =
        must(must(SceneRenderer::create(device, planned.scene)).draw(planned, sampleView(), shafts, false));
    return frame.picture;
}

Image referenceFor(const headless::Device& device, TermSet terms) {
    ViewedScene viewed = must(viewScene(sampleView()));
    for (Light& light : viewed.lights) light = keepOnly(std::move(light), terms);
    const auto scene = must(hardwareScene(device, viewed, sampleView(), ShaftOptions{}.plan.shadowMapSize));
    study::ReferenceOptions options;
    options.accuracy = 1e-6;
    const auto exact = study::reference(scene, options);
    if (!exact) throw std::runtime_error(exact.error().message);
    EXPECT_LE(exact->largestBound, 1e-6);
    return radianceOf(*exact);
}

class AccuracyTest : public testing::TestWithParam<TermSet> {};
INSTANTIATE_TEST_SUITE_P(SampleScene, AccuracyTest, testing::ValuesIn(allTermSets),
                         [](const auto& test) { return std::string(techniqueName(test.param)); });

// Slices at the middles of slabs miss each edge along a ray by up to half a slab, so the error falls as one over
// their number (tests/permutations/reference_test.cpp has the argument), down to the errors of rasterizing on a
// grid of 1/256 pixel and of adding floats.
TEST_P(AccuracyTest, OfSlicesFallsAsOneOverTheirNumberAndRaysAreExact) {
    auto device = headless::Device::create({.validation = true});
    ASSERT_TRUE(device) << device.error().message;
    const Image exact = referenceFor(*device, GetParam());
    std::vector<double> errors;
    for (const int slices : {100, 1000, 4000}) {
        const auto metrics = study::compare(rendered(*device, GetParam(), Method::Slices, slices), exact);
        ASSERT_TRUE(metrics) << metrics.error().message;
        ASSERT_TRUE(metrics->finite());
        errors.push_back(metrics->relativeL2);
        RecordProperty("relative_l2_" + std::to_string(slices), std::to_string(metrics->relativeL2));
    }
    const auto rays = study::compare(rendered(*device, GetParam(), Method::Raycast), exact);
    ASSERT_TRUE(rays) << rays.error().message;
    RecordProperty("relative_l2_raycast", std::to_string(rays->relativeL2));
    EXPECT_TRUE(device->messages().empty()) << device->messages().front();
    EXPECT_LT(rays->relativeL2, 1e-4);
    EXPECT_LT(errors[1], errors[0] / 6.0);
    EXPECT_LT(errors[2], errors[1] / 2.5);
    EXPECT_LT(errors[2], 0.002);
}

}  // namespace
}  // namespace tyndall::test

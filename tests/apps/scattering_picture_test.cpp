// Anisotropy and albedo through the whole program: scene file, plan, slices, picture.
#include <gtest/gtest.h>
#include <headless/device.h>
#include <study/metrics.h>
#include <tyndall/frame/plan_scene.h>
#include <tyndall/frame/reference_scene.h>
#include <tyndall/frame/scene_renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glb.h"
#include "must.h"

namespace tyndall::test {
namespace {

using namespace tyndall::app;
using nlohmann::json;

constexpr int airWidth = 64, airHeight = 36;

struct Air {
    const char* name;
    double anisotropy, density, albedo;  // albedo 0: absent
};

/// An eye at the origin that looks along -Z over 60 degrees. The lamp is at `lamp`, turned by `turn` degrees about +Y
/// from -Z, its beam 40 degrees wide; a square of 0.6 m is at `square`.
std::string beamScene(const Air& air, const std::array<double, 3>& lamp, double turn, double near, double far,
                      const std::array<double, 3>& square) {
    Glb glb;
    glb.json = {{"asset", {{"version", "2.0"}}}, {"extensionsUsed", {"KHR_lights_punctual"}}, {"scene", 0}};
    const std::size_t mesh = glb.addSquare(0.3f);
    json settings = {{"shape", "frustum"}, {"fov", {40.0, 40.0}},    {"near", near},
                     {"far", far},         {"density", air.density}, {"anisotropy", air.anisotropy}};
    if (air.albedo > 0.0) settings["albedo"] = air.albedo;
    const double half = 0.5 * turn * std::numbers::pi / 180.0;
    glb.addNode({{"mesh", mesh}, {"translation", square}});
    glb.addNode({{"camera", 0}});
    glb.addNode({{"name", "Lamp"},
                 {"translation", lamp},
                 {"rotation", {0.0, std::sin(half), 0.0, std::cos(half)}},
                 {"extras", {{"tyndall", settings}}},
                 {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    glb.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
    glb.json["cameras"] = {{{"type", "perspective"},
                            {"perspective", {{"yfov", std::numbers::pi / 3.0}, {"znear", 0.1}, {"zfar", 100.0}}}}};
    glb.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"intensity", 100.0}, {"spot", {{"outerConeAngle", 0.4}}}}};
    return writeScene(glb);
}

ViewOptions viewOf(const std::string& scene) {
    ViewOptions view;
    view.scene = scene;
    view.size = {airWidth, airHeight};
    view.layer = Layer::Shafts;
    return view;
}

Image rendered(const headless::Device& device, const ViewOptions& view, std::optional<int> slices) {
    ShaftOptions shafts;
    shafts.plan.accumulation = Accumulation::Rgba32f;
    if (slices) {
        shafts.plan.slices = *slices;
        shafts.plan.spacing = Spacing::Even;
    }
    PlannedScene planned = must(prepareScene(view));
    const Frame frame = must(must(SceneRenderer::create(device, planned.scene)).draw(planned, view, shafts, false));
    return frame.picture;
}

Image referenceFor(const headless::Device& device, const ViewOptions& view) {
    const ViewedScene viewed = must(viewScene(view));
    const auto scene = must(hardwareScene(device, viewed, view, ShaftOptions{}.plan.shadowMapSize));
    study::ReferenceOptions options;
    options.accuracy = 1e-6;
    const auto exact = study::reference(scene, options);
    if (!exact) throw std::runtime_error(exact.error().message);
    return radianceOf(*exact);
}

class ScatteringPicture : public testing::TestWithParam<Air> {};
INSTANTIATE_TEST_SUITE_P(Air, ScatteringPicture,
                         testing::Values(Air{"Forwards", 0.7, 0.1, 0.0}, Air{"Backwards", -0.6, 0.1, 0.0},
                                         Air{"Even", 0.0, 0.1, 0.4}, Air{"ForwardsDense", 0.7, 0.1, 0.4},
                                         Air{"BackwardsDense", -0.6, 0.1, 0.4}),
                         [](const auto& test) { return std::string(test.param.name); });

// From the side: scattering angles are from 30 to 150 degrees, and both path lengths vary over the picture.
TEST_P(ScatteringPicture, AgreesWithTheReference) {
    auto device = headless::Device::create({.validation = true});
    ASSERT_TRUE(device) << device.error().message;
    const ViewOptions view = viewOf(beamScene(GetParam(), {2.5, 0.1, -5.0}, 110.0, 0.3, 12.0, {0.4, 0.0, -3.0}));
    const Image exact = referenceFor(*device, view);
    const auto equal = study::compare(rendered(*device, view, 4000), exact);
    const auto planned = study::compare(rendered(*device, view, std::nullopt), exact);
    ASSERT_TRUE(equal && planned);
    EXPECT_TRUE(device->messages().empty()) << device->messages().front();
    RecordProperty("relative_l2_4000", std::to_string(equal->relativeL2));
    RecordProperty("relative_l2_planned", std::to_string(planned->relativeL2));
    EXPECT_LT(equal->relativeL2, 0.006);
    EXPECT_LT(planned->relativeL2, 0.05);
}

// A pixel's centre that lies between the rays of the range's grid.
constexpr std::array<double, 3> towardsEye{8.0 * 1.02640 * (2.0 * 34.5 / airWidth - 1.0),
                                           8.0 * 0.57735 * (1.0 - 2.0 * 16.5 / airHeight), -8.0};

struct Shot {
    Air air;
    std::array<double, 3> lamp;
    double turn;
};

class AutomaticRange : public testing::TestWithParam<Shot> {};
INSTANTIATE_TEST_SUITE_P(Air, AutomaticRange,
                         testing::Values(Shot{{"TowardsTheLamp", 0.9, 0.05, 0.0}, towardsEye, 180.0},
                                         Shot{{"NarrowPeakBetweenTheRays", 0.97, 0.05, 0.0}, towardsEye, 180.0},
                                         Shot{{"AlongTheBeam", -0.9, 0.05, 0.0}, {0.2, 0.1, 0.5}, 0.0},
                                         Shot{{"FromTheSide", 0.9, 0.05, 0.0}, {5.0, 0.1, -6.0}, 90.0},
                                         Shot{{"Dense", 0.0, 0.2, 0.2}, towardsEye, 180.0},
                                         Shot{{"LightEndsWithinTwoMetres", 0.0, 1.2, 0.4}, {0.2, 0.1, 0.5}, 0.0},
                                         Shot{{"DenseAndForwards", 0.9, 0.2, 0.4}, towardsEye, 180.0}),
                         [](const auto& test) { return std::string(test.param.air.name); });

// The square is far away: the range ignores shadows. Values above the range
// are clipped in an 8-bit picture; a range twice too wide costs a bit.
TEST_P(AutomaticRange, HoldsTheBrightestPixelAndWastesNoDigits) {
    auto device = headless::Device::create();
    ASSERT_TRUE(device) << device.error().message;
    ViewOptions view = viewOf(beamScene(GetParam().air, GetParam().lamp, GetParam().turn, 1.0, 9.0, {0.0, 50.0, 0.0}));
    const Image picture = rendered(*device, view, 4000);
    const double brightest = *std::max_element(picture.values.begin(), picture.values.end());
    ShaftOptions shafts;
    shafts.plan.accumulation = Accumulation::Rgba8;
    PlannedScene planned = must(prepareScene(view));
    ASSERT_TRUE(planWithoutDepth(planned, view, shafts));
    const double range = planned.range;
    RecordProperty("range_over_brightest", std::to_string(range / brightest));
    EXPECT_GT(range, brightest * 0.97) << "256 steps a ray leave 2 %";
    EXPECT_LT(range, brightest * 1.5);
}

}  // namespace
}  // namespace tyndall::test

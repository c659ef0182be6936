// Light that the plan leaves out is not visible: the sample scenes from random cameras, as planned and with nothing
// left out.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <headless/device.h>
#include <kit/image/tone_map.h>
#include <tyndall/frame/plan_scene.h>
#include <tyndall/frame/scene_renderer.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "displayed.h"
#include "must.h"

namespace tyndall::test {
namespace {

using namespace tyndall::app;

constexpr int cameras = 20;
constexpr Size size{64, 36};

class Cameras {
public:
    Cameras(const PlannedScene& scene, unsigned seed) : scene_(scene), random_(seed) {}

    /// From a random point within the scene's bounds: alternately towards a point in a beam, and in a random direction
    /// up to 40 degrees from level.
    View next() {
        const Bounds& bounds = scene_.scene.bounds;
        glm::dvec3 eye;
        for (int axis = 0; axis < 3; ++axis)
            eye[axis] = glm::mix(bounds.minimum[axis], bounds.maximum[axis], between(0.05, 0.95));
        const double yaw = between(0.0, 360.0), pitch = between(-40.0, 40.0);
        glm::dvec3 towards(glm::rotate(glm::rotate(glm::dmat4(1.0), glm::radians(yaw), {0.0, 1.0, 0.0}),
                                       glm::radians(pitch), {1.0, 0.0, 0.0}) *
                           glm::dvec4(0.0, 0.0, -1.0, 0.0));
        const Light& lamp =
            scene_.lights[static_cast<std::size_t>(between(0.0, 1.0) * static_cast<double>(scene_.lights.size()))];
        const double along = glm::mix(lamp.nearPlane, lamp.farPlane, between(0.0, 0.7));
        const glm::dvec3 lit(lamp.worldFromLight * glm::dvec4(0.0, 0.0, -along, 1.0));
        if (count_++ % 2 == 0) towards = lit - eye;
        return perspectiveView(glm::inverse(glm::lookAt(eye, eye + towards, glm::dvec3(0.0, 1.0, 0.0))),
                               glm::radians(between(30.0, 80.0)), static_cast<double>(size.width) / size.height, 0.1,
                               1000.0);
    }

private:
    /// Equal with every standard library; their distributions differ.
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
    }

    const PlannedScene& scene_;
    std::mt19937 random_;
    int count_ = 0;
};

/// A difference of displayed values, in the display's range.
struct Difference {
    double largest = 0.0;
    std::size_t pixel = 0;
};

Difference compare(const Image& a, const Image& b, double exposure) {
    Difference max;
    for (std::size_t i = 0; i < pixelCount(a); ++i)
        for (int c = 0; c < 3; ++c) {
            const double here = std::abs(displayed(rgbOf(a, i)[c], exposure) - displayed(rgbOf(b, i)[c], exposure));
            if (!(here <= max.largest)) max = {here, i};
        }
    return max;
}

class PlannedEqualsForced : public testing::TestWithParam<const char*> {};

TEST_P(PlannedEqualsForced, FromAnywhere) {
    auto device = headless::Device::create();
    ASSERT_TRUE(device) << device.error().message;
    ViewOptions view;
    view.scene = std::string(TYNDALL_SCENES "/") + GetParam() + ".glb";
    view.size = size;
    ShaftOptions options;
    options.plan.shadowMapSize = 128;
    options.plan.accumulation = Accumulation::Rgba32f;
    PlannedScene scene = must(prepareScene(view));
    SceneRenderer plannedRenderer = must(SceneRenderer::create(*device, scene.scene));
    SceneRenderer forcedRenderer = must(SceneRenderer::create(*device, scene.scene));
    Cameras looking(scene, 3);
    double worst = 0.0;
    std::uint64_t slices = 0, slicesForced = 0;
    for (int camera = 0; camera < cameras; ++camera) {
        scene.view = looking.next();
        options.exposure.reset();
        // The shafts alone use the whole picture's exposure: over black surfaces even the faintest light shows.
        for (const Layer layer : {Layer::All, Layer::Shafts}) {
            view.layer = layer;
            options.plan.everything = false;
            const Frame planned = must(plannedRenderer.draw(scene, view, options, false));
            options.plan.everything = true;
            const Frame forced = must(forcedRenderer.draw(scene, view, options, false));
            const double exposure = options.exposure.value_or(automaticExposure(forced.picture));
            const Difference found = compare(planned.picture, forced.picture, exposure);
            const auto pixel = [&](const Frame& frame) {
                const glm::vec3 p = rgbOf(frame.picture, found.pixel);
                return fmt::format("{} {} {}", p.x, p.y, p.z);
            };
            EXPECT_LE(found.largest, 1.0 / 1024.0)
                << "camera " << camera << ", " << (layer == Layer::All ? "all" : "shafts") << ", pixel "
                << found.pixel % size.width << ", " << found.pixel / size.width << ": planned " << pixel(planned)
                << ", forced " << pixel(forced);
            worst = std::max(worst, found.largest);
            slices += planned.statistics.shafts.slicesDrawn;
            slicesForced += forced.statistics.shafts.slicesDrawn;
            options.exposure = exposure;
        }
    }
    EXPECT_LT(slices, slicesForced) << "else this tests nothing";
    RecordProperty("largest_difference", fmt::format("{:.2g}", worst));
    RecordProperty("slices", std::to_string(slices));
    RecordProperty("slices_forced", std::to_string(slicesForced));
}

INSTANTIATE_TEST_SUITE_P(SampleScenes, PlannedEqualsForced, testing::Values("window", "stage", "cogs", "street"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace tyndall::test

// No steps while eye or lamp move: over 200 frames, pictures change as the integral does.
//
// The pictures have few pixels, because the integral costs time, but small ones: they are cut from the middle of a
// picture with `rows` rows.
#include <gtest/gtest.h>
#include <headless/device.h>
#include <tyndall/frame/plan_scene.h>
#include <tyndall/frame/reference_scene.h>
#include <tyndall/frame/scene_renderer.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "displayed.h"
#include "glb.h"
#include "must.h"

namespace tyndall::test {
namespace {

using namespace tyndall::app;

constexpr int frames = 200;
constexpr double displayStep = 1.0 / 512.0;  // of the display's range

struct Motion {
    std::string name;
    int maxSlices;             // a light
    std::uint32_t shadowSize;  // texels
    Size size;
    double rows;      // of the picture that `size` is cut from
    double exposure;  // stops
    bool ofTheEye;    // else of the lamp
    std::size_t lamp;
    glm::dvec3 step;  // metres a frame: of the eye in its own space, of the lamp in the world's

    friend void PrintTo(const Motion& motion, std::ostream* out) { *out << motion.name; }
};

using Shown = std::vector<glm::dvec3>;  // by pixel, in the display's range

std::vector<glm::vec3> pixelsOf(const Image& image) {
    std::vector<glm::vec3> pixels;
    for (std::size_t i = 0; i < pixelCount(image); ++i) pixels.push_back(rgbOf(image, i));
    return pixels;
}

template <class Pixels>
Shown shownOf(const Pixels& pixels, double exposure) {
    Shown shown;
    for (const auto& pixel : pixels) {
        glm::dvec3& p = shown.emplace_back();
        for (int c = 0; c < 3; ++c) p[c] = displayed(static_cast<double>(pixel[c]), exposure);
    }
    return shown;
}

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Changes from one frame to the next, in the display's range.
struct Changes {
    double drawn = 0.0, integral = 0.0;  ///< the largest
    double excessAtPixel = 0.0;          ///< the largest by which a pixel changed more than its integral
    double meanError = 0.0;              ///< largest mean of the errors of the pixels' changes in one frame
    int minSlices = 1 << 20, maxSlices = 0;
};

class Followed {
public:
    explicit Followed(const std::string& file, const Motion& motion) : motion_(motion) {
        auto made = headless::Device::create();
        if (!made) throw std::runtime_error(made.error().message);
        device_.emplace(std::move(*made));
        view_.scene = file;
        view_.size = motion.size;
        view_.layer = Layer::Shafts;
        shafts_.plan.accumulation = Accumulation::Rgba32f;
        shafts_.exposure = motion.exposure;
        shafts_.plan.shadowMapSize = motion.shadowSize;
        shafts_.plan.slices = motion.maxSlices;
        scene_.emplace(must(prepareScene(view_)));
    }

    PlannedScene& scene() { return *scene_; }

    /// Looks from there with a field of view of 40 degrees; the picture is its middle.
    void look(const glm::dmat4& worldFromEye) {
        const double tangent = std::tan(glm::radians(20.0)) * motion_.size.height / motion_.rows;
        scene_->view = perspectiveView(worldFromEye, 2.0 * std::atan(tangent),
                                       static_cast<double>(motion_.size.width) / motion_.size.height, 0.1, 1000.0);
    }

    Changes follow() {
        SceneRenderer renderer = must(SceneRenderer::create(*device_, scene_->scene));
        Changes changes;
        Shown before, trueBefore;
        for (int frame = 0; frame < frames; ++frame, move()) {
            const Frame drawn = must(renderer.draw(*scene_, view_, shafts_, false));
            const Shown now = shownOf(pixelsOf(drawn.picture), motion_.exposure), trueNow = truth();
            const int slices = static_cast<int>(drawn.statistics.shafts.slicesDrawn);
            changes.minSlices = std::min(changes.minSlices, slices);
            changes.maxSlices = std::max(changes.maxSlices, slices);
            double off = 0.0;
            for (std::size_t i = 0; i < now.size() && frame > 0; ++i) {
                const double changed = largest(now[i] - before[i]), ought = largest(trueNow[i] - trueBefore[i]);
                changes.drawn = std::max(changes.drawn, changed);
                changes.integral = std::max(changes.integral, ought);
                changes.excessAtPixel = std::max(changes.excessAtPixel, changed - ought);
                off += largest(now[i] - before[i] - (trueNow[i] - trueBefore[i]));
            }
            changes.meanError = std::max(changes.meanError, off / static_cast<double>(now.size()));
            before = now;
            trueBefore = trueNow;
        }
        return changes;
    }

private:
    void move() {
        glm::dmat4& eye = scene_->view.worldFromView;
        glm::dmat4& lamp = scene_->lights[motion_.lamp].worldFromLight;
        if (motion_.ofTheEye)
            eye = glm::translate(eye, motion_.step);
        else
            lamp = glm::translate(glm::dmat4(1.0), motion_.step) * lamp;
    }

    Shown truth() const {
        ViewedScene seen = *scene_;
        seen.view.sceneDepth = View{}.sceneDepth;
        const auto hardware = must(hardwareScene(*device_, seen, view_, shafts_.plan.shadowMapSize));
        const auto exact = study::reference(hardware, {.accuracy = 1e-4, .threads = 0, .progress = {}});
        if (!exact) throw std::runtime_error(exact.error().message);
        return shownOf(exact->radiance, motion_.exposure);
    }

    Motion motion_;
    std::optional<headless::Device> device_;
    ViewOptions view_;
    ShaftOptions shafts_;
    std::optional<PlannedScene> scene_;
};

std::string nameOf(const testing::TestParamInfo<Motion>& motion) {
    return motion.param.name;
}

void record(const Changes& changes) {
    const auto steps = [](double change) { return std::to_string(change / displayStep); };
    testing::Test::RecordProperty("largest_change", steps(changes.drawn));
    testing::Test::RecordProperty("largest_change_of_integral", steps(changes.integral));
    testing::Test::RecordProperty("largest_excess_at_a_pixel", steps(changes.excessAtPixel));
    testing::Test::RecordProperty("largest_mean_error_of_change", steps(changes.meanError));
    testing::Test::RecordProperty("slices",
                                  std::to_string(changes.minSlices) + " to " + std::to_string(changes.maxSlices));
    EXPECT_GT(changes.integral, 4.0 * displayStep) << "else nothing moved";
}

/// A lamp that shines past the eye to the right, downwards and away, at the wall 5 m in front of it. It has no edges of
/// cookie or shadow, where slices switch on and off, so each pixel must change as its integral does.
class SoftBeamInMotion : public testing::TestWithParam<Motion> {};

TEST_P(SoftBeamInMotion, NoPixelStepsMoreThanItsIntegral) {
    Glb glb = wallScene();
    const glm::dquat turned =
        glm::quat_cast(glm::inverse(glm::dmat3(glm::lookAt(glm::dvec3(0.0), {1.0, -0.35, -0.25}, {0.0, 1.0, 0.0}))));
    glb.json["nodes"][2]["translation"] = {-1.6, 0.9, -2.6};
    glb.json["nodes"][2]["rotation"] = {turned.x, turned.y, turned.z, turned.w};
    glb.json["nodes"][2]["extras"]["tyndall"] = {{"density", 0.1}, {"near", 0.1}};
    Followed followed(writeScene(glb), GetParam());
    followed.look(glm::inverse(glm::lookAt(glm::dvec3(0.0), {-0.9, 0.65, -2.8}, {0.0, 1.0, 0.0})));
    const Changes changes = followed.follow();
    EXPECT_LE(changes.excessAtPixel, displayStep);
    EXPECT_LE(changes.meanError, displayStep / 4.0);
    EXPECT_LT(changes.minSlices, changes.maxSlices) << "the number of slices changes on the way";
    record(changes);
}

INSTANTIATE_TEST_SUITE_P(Moving, SoftBeamInMotion,
                         testing::Values(Motion{"Eye", 40, 256, {16, 9}, 60.0, 0.0, true, 0, {0.005, 0.0, -0.005}},
                                         Motion{"Lamp", 80, 256, {16, 9}, 60.0, 0.0, false, 0, {0.005, 0.0, 0.0}}),
                         nameOf);

/// When edges of cookies and shadows pass over a pixel, the integral jumps; the drawn jump may come a frame sooner or
/// later. So this compares the largest changes of all pixels, not each pixel with its integral.
class SampleSceneInMotion : public testing::TestWithParam<Motion> {};

TEST_P(SampleSceneInMotion, TheLargestChangeIsThatOfTheIntegral) {
    const std::string name = GetParam().name.substr(0, GetParam().name.find('_'));
    Followed followed(TYNDALL_SCENES "/" + name + ".glb", GetParam());
    followed.look(followed.scene().view.worldFromView);
    const Changes changes = followed.follow();
    EXPECT_LE(changes.drawn, changes.integral + displayStep);
    EXPECT_LE(changes.meanError, displayStep);
    record(changes);
}

INSTANTIATE_TEST_SUITE_P(
    Moving, SampleSceneInMotion,
    testing::Values(Motion{"window_eye", 512, 512, {20, 12}, 90.0, 0.0, true, 0, {0.0, 0.0, -0.005}},
                    Motion{"window_lamp", 512, 512, {20, 12}, 90.0, 0.0, false, 0, {0.005, 0.0, 0.0}},
                    Motion{"cogs_eye", 512, 512, {20, 12}, 90.0, 0.0, true, 0, {0.0, 0.0, -0.005}},
                    Motion{"cogs_lamp", 512, 512, {20, 12}, 90.0, 0.0, false, 0, {0.005, 0.0, 0.0}},
                    Motion{"stage_eye", 512, 256, {16, 9}, 180.0, -2.0, true, 0, {0.005, 0.0, -0.01}},
                    Motion{"stage_lamp", 512, 256, {16, 9}, 180.0, -2.0, false, 3, {0.005, 0.0, 0.0}}),
    nameOf);

}  // namespace
}  // namespace tyndall::test

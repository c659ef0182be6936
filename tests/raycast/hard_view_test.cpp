// Views and lights in which float arithmetic fails first.
#include <gtest/gtest.h>

#include <cmath>

#include "draw.h"
#include "scenes.h"
#include "shot_reference.h"

namespace tyndall::test {
namespace {

const glm::dvec3 lampAt{0.4, 2.9, -0.3}, lampDirection = glm::normalize(glm::dvec3(-0.25, -0.9, 0.2));

Shot seenFrom(const glm::dvec3& position, const glm::dvec3& direction) {
    Shot shot = sideView();
    shot.eye.worldFromView = lookAlong(position, direction);
    shot.eye.nearPlane = 0.01;
    shot.width = shot.height = 48;
    return shot;
}

Shot stripes() {
    Shot shot = sideView();
    shot.width = shot.height = 48;
    shot.cookieMap = makeTexture(64, 64, 4, [](int x, int, int) { return x % 2 ? 1.0 : 0.0; });
    shot.shadowMap =
        makeTexture(64, 64, 1, [&](int, int y, int) { return y % 2 ? storedShadowDepth(shot.light, 1.5) : 0.0; });
    return shot;
}

Shot farAway(double distance) {
    const glm::dvec3 middle = lampAt + 2.0 * lampDirection;
    const glm::dvec3 away = glm::normalize(glm::dvec3(0.6, 0.1, 1.0));
    Shot shot = seenFrom(middle + distance * away, -away);
    shot.eye.verticalFov = 2.0 * std::atan(2.0 / distance);
    shot.eye.nearPlane = 0.1 * distance;
    shot.eye.farPlane = 10.0 * distance;
    return shot;
}

// The eye beside the lamp at this distance: rays pass the lamp closely.
Shot beside(double distance) {
    Shot shot = seenFrom(lampAt + distance * glm::dvec3(0.8, 0.0, 0.6), lampDirection + glm::dvec3(0.1, 0.0, 0.2));
    shot.light.nearPlane = 0.001;
    shot.eye.nearPlane = 0.001;
    return shot;
}

Shot fan(double width, double height) {
    Shot shot = sideView();
    shot.width = shot.height = 48;
    shot.light.fov = glm::radians(glm::dvec2(width, height));
    shot.eye.verticalFov = height < 1.0 && width < 1.0 ? 0.02 : 0.8;
    return shot;
}

Shot withMap(int size) {
    Shot shot = sideView();
    shot.width = shot.height = 48;
    shot.shadowMap = makeTexture(size, size, 1, [&](int x, int y, int) {
        return (x * 7 + y * 3) % 5 < 2 ? storedShadowDepth(shot.light, 1.2 + 0.3 * ((x + y) % 4)) : 0.0;
    });
    return shot;
}

std::vector<NamedShot> hardShots() {
    std::vector<NamedShot> all{
        {"eye_at_the_lamp", seenFrom(lampAt, lampDirection)},
        {"eye_at_the_lamp_sideways", seenFrom(lampAt, lampDirection + glm::dvec3(0.5, 0.2, 0.1))},
        {"eye_in_the_near_plane", seenFrom(lampAt + 0.4 * lampDirection, {0.2, -0.9, 0.3})},
        {"along_the_axis", seenFrom(lampAt - 0.7 * lampDirection, lampDirection)},
        {"against_the_axis", seenFrom(lampAt + 5.0 * lampDirection, -lampDirection)},
        {"across_the_axis", seenFrom(lampAt + 2.0 * lampDirection + glm::dvec3(3, 0, 0), {-1, 0, 0})},
        {"stripes_of_one_texel", stripes()},
        {"fan_60x1", fan(60.0, 1.0)},
        {"beam_1x1", fan(1.0, 1.0)},
        {"fan_170x170", fan(170.0, 170.0)},
    };
    for (const double distance : {0.3, 0.01, 0.001})
        all.push_back(
            {"beside_the_lamp_" + std::to_string(static_cast<int>(distance * 1000)) + "mm", beside(distance)});
    for (const int distance : {100, 10000})
        all.push_back({"from_" + std::to_string(distance) + "_m", farAway(distance)});
    for (const int size : {1, 2, 3, 100}) all.push_back({"map_of_" + std::to_string(size), withMap(size)});
    return all;
}

[[maybe_unused]] void PrintTo(const NamedShot& shot, std::ostream* out) {
    *out << shot.name;
}

class RaycastHardView : public GpuTest, public testing::WithParamInterface<NamedShot> {};
INSTANTIATE_TEST_SUITE_P(RaycastFx, RaycastHardView, testing::ValuesIn(hardShots()),
                         [](const auto& test) { return test.param.name; });

TEST_P(RaycastHardView, IsTheIntegral) {
    for (const TermSet terms :
         {TermSet{}, TermSet{Term::Shadow}, TermSet{Term::Shadow, Term::Cookie, Term::Noise}, TermSet::all()}) {
        const Shot shot = withTerms(GetParam().shot, terms);
        if (terms.contains(Term::Scattering) && GetParam().name == "from_10000_m") continue;  // all is absorbed
        DrawOptions options;
        options.method = Method::Raycast;
        options.terms = terms;
        const Drawing drawing = draw(shot, options);
        ASSERT_EQ(whyNotFinite(drawing.sum), "");
        EXPECT_GT(litPixels(drawing.sum), 10);
        const double error = relativeL2(drawing.sum, truth(shot, 1.0));
        RecordProperty("relative_l2_" + std::to_string(terms.index()), std::to_string(error));
        EXPECT_LT(error, 1e-4) << techniqueName(terms);
    }
}

// A torch: the eye at the lamp.
Drawing torch(double near, double far, TermSet terms) {
    Shot shot = seenFrom(lampAt, lampDirection);
    shot.light.nearPlane = near;
    shot.light.farPlane = far;
    shot.light.ambient = 1.0;
    shot.light.albedo.reset();
    shot.shadowBias = 0.0;
    shot.shadowMap = constantTexture(8, 8, {0.0f});
    shot.eye.nearPlane = near;
    shot.eye.farPlane = 10.0 * far;
    DrawOptions options;
    options.method = Method::Raycast;
    options.terms = terms;
    return draw(withTerms(shot, terms), options);
}

class RaycastTorch : public GpuTest {};

// Along each ray from the lamp the slide and the angle of scattering are the same at all depths. So they are a factor,
// whatever the depths; the reference is no help, because its quadrature fails over fifteen orders of magnitude.
TEST_F(RaycastTorch, ShowsItsSlideAtEveryDepth) {
    const TermSet masks = TermSet::all();
    std::vector<double> factors;
    for (const auto& [near, far] : {std::pair(0.4, 4.5), std::pair(1e-3, 1e4), std::pair(1e-6, 1e9)}) {
        const Drawing plain = torch(near, far, {}), masked = torch(near, far, masks);
        ASSERT_EQ(whyNotFinite(plain.sum) + whyNotFinite(masked.sum), "");
        ASSERT_GT(litPixels(masked.sum), 200);
        std::size_t i = 0;
        for (std::size_t pixel = 0; pixel < plain.sum.pixels.size(); ++pixel) {
            const double a = static_cast<double>(plain.sum.pixels[pixel][0]);
            const double b = static_cast<double>(masked.sum.pixels[pixel][0]);
            const double factor = a > 0.0 ? b / a : 0.0;
            if (near == 0.4)
                factors.push_back(factor);
            else
                EXPECT_NEAR(factor, factors[i], 1e-4 * factors[i]) << pixel << " from " << near;
            ++i;
        }
    }
}

}  // namespace
}  // namespace tyndall::test

// The shader's constants, against the optics.
#include <gtest/gtest.h>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

SliceConstants firstConstants(const Scene& scene, const PlanOptions& options) {
    const Plan result = planned({scene.light}, scene.view, options);
    EXPECT_TRUE(!result.lights.empty() && result.lights[0].drawn);
    return result.constants.empty() ? SliceConstants{} : result.constants[0];
}

Scene someScene() {
    Random random(1);
    return randomScene(random);
}

constexpr double fourPi = 4.0 * 3.14159265358979323846;

TEST(Constants, ProjectAsTheSlideDoes) {
    Random random(2);
    for (int trial = 0; trial < 5; ++trial) {
        const Scene scene = randomScene(random);
        const SliceConstants constants = firstConstants(scene, slices(4));
        for (int sample = 0; sample < 50; ++sample) {
            // Two angles give a ray from the lamp; its slide coordinates are those of its intersection with the slide.
            const double toRight = between(random, -20.0, 20.0) * degrees;
            const double upward = between(random, -12.0, 12.0) * degrees;
            const double axis = between(random, 0.5, 6.0);
            const glm::dvec4 inLight(axis * std::tan(toRight), axis * std::tan(upward), -axis, 1.0);
            const glm::dvec4 inView = glm::inverse(scene.view.worldFromView) * (scene.light.worldFromLight * inLight);

            const glm::dvec3 p(glm::dmat4(constants.lightFromView) * inView);
            for (int i = 0; i < 3; ++i) EXPECT_NEAR(p[i], inLight[i], 1e-5);  // floats of the matrix, at 16 m
            const double u = (p.x * constants.cookieScale.x - 0.5 * p.z) / -p.z;
            const double v = (-p.y * constants.cookieScale.y - 0.5 * p.z) / -p.z;
            EXPECT_NEAR(u, 0.5 + 0.5 * std::tan(toRight) / std::tan(20.0 * degrees), 1e-4);
            EXPECT_NEAR(v, 0.5 - 0.5 * std::tan(upward) / std::tan(12.0 * degrees), 1e-4);

            const glm::dvec4 map = lightClipFromLight(scene.light) * inLight;
            EXPECT_NEAR(0.5 + 0.5 * map.x / map.w, u, 1e-4);
            EXPECT_NEAR(0.5 + 0.5 * map.y / map.w, v, 1e-4);
            EXPECT_NEAR(constants.shadow.x + constants.shadow.y / axis, map.z / map.w, 1e-7);

            const glm::dvec4 seen = scene.view.clipFromView * inView;
            for (int i = 0; i < 4; ++i) EXPECT_NEAR((glm::dmat4(constants.clipFromView) * inView)[i], seen[i], 1e-5);
        }
    }
}

TEST(Constants, OfThePhysicalLook) {
    Scene scene = someScene();
    scene.light.colour = {1.0, 0.5, 0.25};
    scene.light.intensity = 300.0;
    scene.light.ambient = 2.0;
    scene.light.density = 0.03;
    const SliceConstants constants = firstConstants(scene, slices(50));
    EXPECT_EQ(constants.attenuation, glm::vec4(300.0f, 2.0f, 1.0f, 0.0f));
    EXPECT_EQ(constants.dust.x, 1.0f);
    for (int i = 0; i < 3; ++i)
        EXPECT_FLOAT_EQ(constants.colour[i], static_cast<float>(scene.light.colour[i] * 0.03 / fourPi));
    EXPECT_EQ(constants.colour.w, 0.0f);
    EXPECT_EQ(constants.weight, glm::vec4(1.0f, 1.0f, 1.0f, 0.0f));
}

TEST(Constants, OfAnOrthographicView) {
    Scene scene = someScene();
    scene.view = orthographicView(scene.view.worldFromView, 8.0, 8.0, 0.01, 100.0);
    EXPECT_EQ(firstConstants(scene, slices(50)).weight, glm::vec4(1.0f, 1.0f, 0.0f, 0.0f)) << "no ray is slanted";
}

TEST(Constants, OfTheArticle) {
    Scene scene = someScene();
    scene.light.colour = {1.0, 0.5, 0.25};
    scene.light.density = 0.3;
    scene.light.noise = Noise{};
    PlanOptions options = slices(50);
    options.look = Look::Article;
    options.accumulation = Accumulation::Rgba8;
    options.range = 2.0;
    const SliceConstants constants = firstConstants(scene, options);
    EXPECT_EQ(constants.attenuation, glm::vec4(20000.0f, 0.25f, 39.37007874f, 0.0f)) << "inches to the metre";
    EXPECT_EQ(constants.dust, glm::vec4(0.015f, 0.05f, 0.0f, 0.0f));
    EXPECT_EQ(constants.weight, glm::vec4(18.0f, 0.0f, 0.0f, 0.0f)) << "9 / (50 / 100)";
    EXPECT_EQ(constants.colour, glm::vec4(0.5f, 0.25f, 0.125f, 0.0f)) << "no density, half range";
}

TEST(Constants, ScaleToTheTargetsRange) {
    const Scene scene = someScene();
    PlanOptions options = slices(8);
    const float whole = firstConstants(scene, options).colour.r;
    options.range = 5.0;
    for (const auto& [accumulation, scale] :
         std::vector<std::pair<Accumulation, double>>{{Accumulation::Rgba8, 0.2},
                                                      {Accumulation::Rgba8Routed, 0.2},
                                                      {Accumulation::Rgba16f, 1.0},
                                                      {Accumulation::Rgba32f, 1.0}}) {
        options.accumulation = accumulation;
        EXPECT_EQ(planned({scene.light}, scene.view, options).scale, scale);
        EXPECT_FLOAT_EQ(firstConstants(scene, options).colour.r, static_cast<float>(whole * scale));
    }
}

TEST(Constants, NoiseScrollsWithoutLosingItsPhase) {
    Scene scene = someScene();
    scene.light.noise = Noise{{3.0, 4.0}, {0.25, -0.25}, {-1.5, 0.02}, 2.0};
    PlanOptions options = slices(8);
    options.time = 3.0;
    SliceConstants constants = firstConstants(scene, options);
    EXPECT_EQ(constants.noise1, glm::vec4(3.0f, 4.0f, 0.75f, 0.25f));
    EXPECT_EQ(constants.noise2.x, 3.0f);
    EXPECT_EQ(constants.noise2.y, 4.0f);
    EXPECT_EQ(constants.noise2.z, 0.5f);
    EXPECT_NEAR(constants.noise2.w, 0.06, 1e-7);
    EXPECT_EQ(constants.dust, glm::vec4(1.0f, 2.0f, 0.0f, 0.0f));

    // A million hours later, after whole turns, nothing has changed.
    options.time += 3.6e9;
    const SliceConstants later = firstConstants(scene, options);
    EXPECT_EQ(later.noise1, constants.noise1);
    EXPECT_NEAR(later.noise2.w, constants.noise2.w, 1e-7);

    // Just before zero is just before a whole turn, which a float rounds to 1.
    options.time = -1e-12;
    constants = firstConstants(scene, options);
    for (const glm::vec4& map : {constants.noise1, constants.noise2})
        for (const float part : {map.z, map.w}) {
            EXPECT_GE(part, 0.0f);
            EXPECT_LT(part, 1.0f);
        }
}

TEST(Constants, ForcedNoiseOnWhiteLooksLikeNone) {
    Scene scene = someScene();
    PlanOptions options = slices(8);
    options.terms = TermSet{Term::Noise};
    EXPECT_EQ(firstConstants(scene, options).dust.y, 1.0f);
    EXPECT_EQ(firstConstants(scene, options).noise1.x, 3.0f) << "the default's scale";
    options.look = Look::Article;
    EXPECT_EQ(firstConstants(scene, options).dust.y, 0.015f) << "as flat as without noise";
}

TEST(Constants, ShadowBiasStaysThisSideOfTheNearPlane) {
    const Scene scene = someScene();
    PlanOptions options = slices(8);
    options.shadowMapSize = 2048;
    options.shadowBias = 0.01;
    EXPECT_EQ(firstConstants(scene, options).shadow.z, 2048.0f);
    EXPECT_EQ(firstConstants(scene, options).shadow.w, 0.01f);
    options.shadowBias = 10.0;  // the near plane lies at 0.5
    const glm::vec4 shadow = firstConstants(scene, options).shadow;
    EXPECT_GT(shadow.x + shadow.y / (0.5f - shadow.w), 1.0f) << "what touches the lamp is lit, not behind it";
}

}  // namespace
}  // namespace tyndall

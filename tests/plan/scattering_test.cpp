// Bounds of the scattering term over the seen air, against its points; and the lights that get the term.
#include "needs/scattering.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

// The formula of slices.fx, by cosine and powers.
double factorAt(const Light& light, const View& view, const LightPose& pose, const glm::dvec3& p) {
    const glm::dvec3 fromLamp = p - glm::dvec3(pose.viewFromLight[3]);
    const glm::dvec3 toEye = view.orthographic ? glm::dvec3(0.0, 0.0, 1.0) : glm::normalize(-p);
    const double g = light.anisotropy, cosine = glm::dot(glm::normalize(fromLamp), toEye);
    const double phase = (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
    const double way = glm::length(fromLamp) + (view.orthographic ? -p.z : glm::length(p));
    return phase * (light.albedo ? std::exp(-light.density / *light.albedo * way) : 1.0);
}

TEST(ScatteringRange, HoldsEveryPointAndIsNearlyMetBySome) {
    Random random(3);
    double tightest = 0.0;
    for (int trial = 0; trial < 400; ++trial) {
        Light light = projector();
        light.anisotropy = between(random, -0.98, 0.98);
        light.density = between(random, 0.01, 0.5);
        if (trial % 3 != 0) light.albedo = between(random, 0.05, 1.0);
        const View view = trial % 4 == 0 ? orthographicView(glm::dmat4(1.0), 3.0, 3.0, 0.1, 100.0)
                                         : perspectiveView(glm::dmat4(1.0), 1.0, 1.0, 0.1, 100.0);
        light.worldFromLight = rigidMotion(random, 4.0);
        light.worldFromLight[3].z -= 5.0;
        const LightPose pose = lightPose(light.worldFromLight, view.worldFromView);
        SeenAir air;
        air.any = true;
        air.axisNear = between(random, 0.1, 2.0);
        air.axisFar = air.axisNear + between(random, 0.01, 2.0);
        air.slopes.min = {between(random, -0.5, 0.3), between(random, -0.5, 0.3)};
        air.slopes.max = air.slopes.min + glm::dvec2(between(random, 0.01, 0.4), between(random, 0.01, 0.4));
        air.nearDepth = 0.1;
        air.farDepth = 100.0;
        const FactorRange range = scatteringRange(light, view, pose, air);
        double min = std::numeric_limits<double>::infinity(), max = 0.0;
        for (int i = 0; i < 200; ++i) {
            const double axis = between(random, air.axisNear, air.axisFar);
            const glm::dvec2 slope(between(random, air.slopes.min.x, air.slopes.max.x),
                                   between(random, air.slopes.min.y, air.slopes.max.y));
            const glm::dvec3 p(pose.viewFromLight * glm::dvec4(glm::dvec3(slope, -1.0) * axis, 1.0));
            if (-p.z < air.nearDepth) continue;
            const double factor = factorAt(light, view, pose, p);
            min = std::min(min, factor);
            max = std::max(max, factor);
        }
        if (max == 0.0) continue;
        EXPECT_LE(range.min.x, min * (1.0 + 1e-9)) << trial;
        EXPECT_GE(range.max.x, max * (1.0 - 1e-9)) << trial;
        EXPECT_LE(range.max.x, phasePeak(light) * (1.0 + 1e-12)) << trial;
        tightest = std::max(tightest, (max - min) / (range.max.x - range.min.x));
    }
    EXPECT_GT(tightest, 0.5) << "a bound that nothing comes near tells little";
}

TEST(Scattering, IsAskedForByAnisotropyOrAlbedo) {
    Light light = projector();
    EXPECT_FALSE(termsOf(light).contains(Term::Scattering));
    light.anisotropy = -0.1;
    EXPECT_TRUE(termsOf(light).contains(Term::Scattering));
    light.anisotropy = 0.0;
    light.albedo = 1.0;
    EXPECT_TRUE(termsOf(light).contains(Term::Scattering));
    EXPECT_EQ(termsOf(keepOnly(light, TermSet::all().without(Term::Scattering))).contains(Term::Scattering), false);
}

TEST(Scattering, WhatItCannotBeIsRefused) {
    const auto message = [](double g, std::optional<double> albedo) {
        Light light = projector();
        light.anisotropy = g;
        light.albedo = albedo;
        const auto made = plan(std::span(&light, 1), wideView(glm::dmat4(1.0)), slices(4));
        return made ? std::string() : made.error().message;
    };
    for (const double g : {1.0, -1.0, 3.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_NE(message(g, {}).find("anisotropy is "), std::string::npos) << g;
    for (const double albedo : {0.0, -1.0, 1.001, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_NE(message(0.0, albedo).find("albedo is "), std::string::npos) << albedo;
    EXPECT_EQ(message(-0.999, 0.001), "");
}

}  // namespace
}  // namespace tyndall

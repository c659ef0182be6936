// The reference in air with a phase function and extinction: closed forms in long double, and laws of both factors.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "oracle_volume.h"
#include "quadrature.h"
#include "scenes.h"
#include "study_scene.h"

namespace tyndall::test {
namespace {

using study::Mode, study::ReferenceImage, study::ReferenceOptions, study::ReferenceScene;
using Real = long double;
constexpr Real pi = 3.14159265358979323846264338327950L;

/// A ray with the lamp at the origin: the point s metres behind the foot is h metres off the lamp's nearest.
struct Chord {
    Real begin = 0, end = 0;  ///< within the light, from the foot
    Real h = 0, toFoot = 0;
    bool empty() const { return !(begin < end); }
};

Chord chordOf(const Light& light, glm::dvec3 p, glm::dvec3 d) {
    Chord chord;
    Real squared = 0, length = 0;
    for (int i = 0; i < 3; ++i) {
        chord.toFoot -= static_cast<Real>(p[i]) * static_cast<Real>(d[i]);
        length += static_cast<Real>(d[i]) * static_cast<Real>(d[i]);
    }
    chord.toFoot /= length;
    for (int i = 0; i < 3; ++i) {
        const Real across = static_cast<Real>(p[i]) + chord.toFoot * static_cast<Real>(d[i]);
        squared += across * across;
    }
    chord.h = std::sqrt(squared);
    Real begin = oneRayNear, end = 1e4L;
    for (const HalfSpace& plane : lightVolume(light, glm::dmat4(1.0))) {
        const Real at = static_cast<Real>(plane.distance(p)), slope = static_cast<Real>(glm::dot(plane.normal, d));
        if (slope > 0) begin = std::max(begin, -at / slope);
        if (slope < 0) end = std::min(end, -at / slope);
        if (slope == 0 && at < 0) end = begin;
    }
    chord.begin = begin - chord.toFoot;
    chord.end = end - chord.toFoot;
    return chord;
}

/// Rays from points around plainLight(), directed at its volume.
struct Line {
    glm::dvec3 position, direction;
};
Line randomLine(Random& random) {
    const glm::dvec3 p = uniform(random, 1.0, 6.0) * direction(random);
    const glm::dvec3 inside(uniform(random, -1, 1), uniform(random, -0.6, 0.6), uniform(random, -3.5, -1.0));
    return {p, glm::normalize(inside - p)};
}

Real scale(const Light& light) {
    return static_cast<Real>(light.density) / (4 * pi);
}

// Integral over c from a to b of exp(-e c) (1 + h^2 / c^2) / 2, with the exponential integral E1(x) = -Ei(-x).
Real absorbed(Real e, Real h, Real a, Real b) {
    const auto above = [&](Real c) {
        const Real x = e * c, second = std::exp(-x) + x * std::expint(-x);  // E2
        return 0.5L * (std::exp(-x) / e + h * h * second / c);
    };
    return above(a) - above(b);
}

// Ambient light alone, in air that absorbs. With c = d + s, the path from the lamp via the particle to the foot, s =
// (c^2 - h^2) / (2 c) and ds = (1 + h^2 / c^2) / 2 dc.
TEST(ScatteringClosedForm, AmbientInAirThatAbsorbs) {
    Random random(5);
    int lit = 0;
    for (int i = 0; i < 300; ++i) {
        Light light = plainLight();
        light.intensity = 0.0;
        light.ambient = 2.0;
        light.density = std::pow(10.0, uniform(random, -3.0, 1.0));
        light.albedo = uniform(random, 0.2, 1.0);
        const Line line = randomLine(random);
        const Chord chord = chordOf(light, line.position, line.direction);
        const double value = radianceOf(oneRay(light, line.position, line.direction), 1e-12).x;
        if (chord.empty()) {
            EXPECT_EQ(value, 0.0);
            continue;
        }
        const Real e = static_cast<Real>(light.density) / static_cast<Real>(*light.albedo);
        const auto way = [&](Real s) { return std::hypot(chord.h, s) + s; };
        const Real sum = absorbed(e, chord.h, way(chord.begin), way(chord.end));
        const double exact = static_cast<double>(scale(light) * 2 * std::exp(-e * chord.toFoot) * sum);
        // The closed form is a difference; both values are accurate to 1e-12 of its terms.
        const Real a = way(chord.begin);
        const Real size = scale(light) * 2 * std::exp(-e * (chord.toFoot + a)) * (1 / e + chord.h * chord.h / a);
        EXPECT_NEAR(value, exact, 1e-12 * static_cast<double>(size) + 1e-11 * exact) << i;
        lit += exact > 0.0;
    }
    EXPECT_GT(lit, 200);
}

// Looking straight at the lamp, the path is the same for every particle in between: the factor is exp(-e D). Away from
// the lamp the path grows by two metres per metre.
TEST(ScatteringClosedForm, TowardsTheLampAndAwayFromIt) {
    Light light = plainLight();
    light.density = 0.4;
    light.albedo = 0.5;
    light.ambient = 0.3;
    light.anisotropy = 0.6;
    const Real e = 0.8L, forward = 1.6L / (0.4L * 0.4L), backward = 0.4L / (1.6L * 1.6L);
    const Real lamp = 30 * (1 / 0.5L - 1 / 4.0L) + 0.3L * 3.5L;
    const double towards = static_cast<double>(scale(light) * forward * std::exp(-e * 5) * lamp);
    EXPECT_NEAR(radianceOf(oneRay(light, {0, 0, -5}, {0, 0, 1}), 1e-12).x, towards, 1e-11 * towards);

    light.intensity = 0.0;
    const Real falling = 0.3L * (std::exp(-2 * e * 0.5L) - std::exp(-2 * e * 4)) / (2 * e);
    const double away = static_cast<double>(scale(light) * backward * std::exp(-e * 2) * falling);
    EXPECT_NEAR(radianceOf(oneRay(light, {0, 0, 2}, {0, 0, -1}), 1e-12).x, away, 1e-11 * away);
}

// Integral over the angle t from the foot, tan(t) = s / h, of the phase function at cos = -sin(t). With
// p = pi / 4 - t / 2 the base is (1 + g)^2 (1 - k^2 sin^2 p), k^2 = 4 g / (1 + g)^2, and
// integral dp / (1 - k^2 sin^2 p)^(3/2) = (E(p, k) - k^2 sin p cos p / sqrt(1 - k^2 sin^2 p)) / (1 - k^2)
// (Byrd and Friedman, Handbook of Elliptic Integrals, 315.02).
Real phaseOverAngle(Real g, Real from, Real to) {
    const Real k2 = 4 * g / ((1 + g) * (1 + g)), rest = (1 - g) * (1 - g) / ((1 + g) * (1 + g));
    const auto primitive = [&](Real p) {
        const Real root = std::sqrt(std::cos(p) * std::cos(p) + rest * std::sin(p) * std::sin(p));
        return (std::ellint_2(std::sqrt(k2), p) - k2 * std::sin(p) * std::cos(p) / root) / rest;
    };
    const auto turned = [](Real t) { return pi / 4 - t / 2; };
    return 2 * (1 - g * g) / ((1 + g) * (1 + g) * (1 + g)) * (primitive(turned(from)) - primitive(turned(to)));
}

TEST(ScatteringClosedForm, InverseSquareLightAndThePhaseFunction) {
    Random random(6);
    int lit = 0;
    for (int i = 0; i < 400; ++i) {
        Light light = plainLight();
        const double narrow = std::pow(10.0, uniform(random, -4.0, 0.0));
        light.anisotropy = (i % 2 == 0 ? 1.0 : -1.0) * (1.0 - narrow);
        const Line line = randomLine(random);
        const Chord chord = chordOf(light, line.position, line.direction);
        const double value = radianceOf(oneRay(light, line.position, line.direction), 1e-12).x;
        if (chord.empty()) continue;
        // Backward scattering is forward scattering along the reversed ray.
        const Real begin = light.anisotropy < 0.0 ? -chord.end : chord.begin;
        const Real end = light.anisotropy < 0.0 ? -chord.begin : chord.end;
        const Real g = std::abs(static_cast<Real>(light.anisotropy));
        const Real angle = phaseOverAngle(g, std::atan(begin / chord.h), std::atan(end / chord.h));
        const Real perAngle = scale(light) * 30 / chord.h;
        const double exact = static_cast<double>(perAngle * angle);
        // libstdc++'s ellint_2 is off by 1.3e-15 of its value, which is at most 3 here for both ends together, and that
        // is divided by 1 - k^2: 2 (1 - g^2) / (1 + g)^3 / (1 - k^2) = 2 / (1 - g).
        const double closed = static_cast<double>(perAngle * 2 / (1 - g)) * 3 * 1.3e-15;
        EXPECT_NEAR(value, exact, 1e-11 * exact + closed) << i << " g " << light.anisotropy;
        lit += exact > 0.0;
    }
    EXPECT_GT(lit, 300);
}

// A g close to 0 without effect uses the code without closed forms.
TEST(Scattering, TheIntegratedWayFindsWhatTheClosedFormSays) {
    for (std::uint64_t seed = 0; seed < 6; ++seed)
        for (const Mode mode : {Mode::Ideal, Mode::Hardware}) {
            const ReferenceScene even = randomScene(seed, mode);
            ReferenceScene integrated = even;
            for (auto& light : integrated.lights) light.light.anisotropy = 1e-300;
            const auto a = study::reference(even), b = study::reference(integrated);
            ASSERT_TRUE(a && b);
            for (std::size_t i = 0; i < a->radiance.size(); ++i)
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(b->radiance[i][c], a->radiance[i][c], (a->bound[i] + b->bound[i]) * a->radiance[i][c]);
        }
}

/// Light that one particle sends when light turns by the angle of this cosine, relative to even scattering.
double phaseSeen(double g, double cosine) {
    const double thin = 1e-6;
    const glm::dvec3 place(0.0, 0.0, -2.0);
    const glm::dvec3 toEye(std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), 0.0, -cosine);
    Light light = plainLight();
    for (const double side : {1.0, -1.0})
        light.clipPlanes.push_back(glm::dvec4(side * toEye, -side * glm::dot(toEye, place) + thin));
    // Slightly off the lamp: a ray through it has no foot.
    const glm::dvec3 eye = place + 1.5 * toEye + glm::dvec3(0.0, 1e-9, 0.0);
    const double even = radianceOf(oneRay(light, eye, -toEye)).x;
    light.anisotropy = g;
    return radianceOf(oneRay(light, eye, -toEye)).x / even;
}

TEST(Scattering, AllThatAParticleSendsIsAllThatItGets) {
    for (const double g : {-0.95, -0.5, 0.0, 0.3, 0.8, 0.95}) {
        const auto share = [&](double cosine) { return glm::dvec3(0.5 * phaseSeen(g, cosine)); };
        const study::Quadrature sphere = study::integrate(share, -1.0, 1.0, 1e-7);
        EXPECT_NEAR(sphere.value.x, 1.0, 1e-6) << g;
        // Its mean cosine is g, by definition.
        const auto moment = [&](double cosine) { return glm::dvec3(0.5 * (1.0 + cosine) * phaseSeen(g, cosine)); };
        EXPECT_NEAR(study::integrate(moment, -1.0, 1.0, 1e-7).value.x, 1.0 + g, 1e-6) << g;
    }
}

TEST(Scattering, IsBrightTowardsTheLampWhereGIsPositive) {
    EXPECT_NEAR(phaseSeen(0.5, 1.0), 1.5 / (0.5 * 0.5), 1e-5);
    EXPECT_NEAR(phaseSeen(0.5, -1.0), 0.5 / (1.5 * 1.5), 1e-5);
    EXPECT_NEAR(phaseSeen(-0.5, 1.0), 0.5 / (1.5 * 1.5), 1e-5);
}

// On the reversed ray light turns by the supplementary angle, like a g of the other sign.
TEST(Scattering, TheOppositeRaySeesTheOppositeG) {
    Random random(8);
    int lit = 0;
    for (int i = 0; i < 100; ++i) {
        Light light = plainLight();
        light.anisotropy = uniform(random, -0.99, 0.99);
        light.ambient = uniform(random, 0.0, 2.0);
        const Line line = randomLine(random);
        const double there = radianceOf(oneRay(light, line.position, line.direction)).x;
        const Chord chord = chordOf(light, line.position, line.direction);
        if (chord.empty() || chord.begin + chord.toFoot < 0.01L) continue;
        light.anisotropy = -light.anisotropy;
        const double back = radianceOf(oneRay(light, line.position + 20.0 * line.direction, -line.direction)).x;
        EXPECT_NEAR(back, there, 1e-9 * there) << i;
        lit += there > 0.0;
    }
    EXPECT_GT(lit, 60);
}

ReferenceImage rendered(const ReferenceScene& scene) {
    auto image = study::reference(scene);
    if (!image) throw std::runtime_error(image.error().message);
    return std::move(*image);
}

TEST(Scattering, StrongerExtinctionIsNeverBrighter) {
    int darker = 0;
    for (std::uint64_t seed = 200; seed < 212; ++seed) {
        ReferenceScene scene = scatteringScene(seed, seed % 2 == 0 ? Mode::Ideal : Mode::Hardware);
        for (auto& light : scene.lights) light.light.albedo.reset();
        ReferenceImage before = rendered(scene);
        for (const double albedo : {1.0, 0.5, 0.1, 0.001, 1e-5}) {
            for (auto& light : scene.lights) light.light.albedo = albedo;
            ReferenceImage after = rendered(scene);
            for (std::size_t i = 0; i < after.radiance.size(); ++i)
                for (int c = 0; c < 3; ++c) {
                    EXPECT_TRUE(std::isfinite(after.radiance[i][c]));
                    EXPECT_LE(after.radiance[i][c], before.radiance[i][c] * (1.0 + 2e-8)) << seed << " " << albedo;
                    darker += after.radiance[i][c] < 0.9 * before.radiance[i][c];
                }
            before = std::move(after);
        }
    }
    EXPECT_GT(darker, 1000);
}

// Peaks as narrow as 1e-9, and air so thick that a millimetre is dark: the bound holds.
TEST(Scattering, TheBoundHoldsForNarrowPeaksAndThickAir) {
    int lit = 0;
    for (std::uint64_t seed = 300; seed < 306; ++seed)
        for (const double narrow : {1e-3, 1e-6, 1e-9})
            for (const double albedo : {1.0, 1e-3}) {
                ReferenceScene scene = scatteringScene(seed, Mode::Hardware);
                for (auto& light : scene.lights) {
                    light.light.anisotropy = std::copysign(1.0 - narrow, light.light.anisotropy);
                    light.light.albedo = albedo;
                }
                ReferenceOptions options;
                options.accuracy = 1e-12;
                const auto best = study::reference(scene, options);
                options.accuracy = 1e-6;
                const auto image = study::reference(scene, options);
                ASSERT_TRUE(best && image);
                for (std::size_t i = 0; i < best->radiance.size(); ++i)
                    for (int c = 0; c < 3; ++c) {
                        EXPECT_NEAR(image->radiance[i][c], best->radiance[i][c],
                                    (image->bound[i] + best->bound[i]) * best->radiance[i][c]);
                        lit += best->radiance[i][c] > 0.0;
                    }
                // The peak is at a direction, which doubles resolve to about 1e-14.
                EXPECT_LT(image->largestBound, 1e-5 + 1e-11 / narrow);
            }
    EXPECT_GT(lit, 1000);
}

TEST(Scattering, WhatItCannotBeIsRefused) {
    const auto message = [](double g, std::optional<double> albedo) {
        Light light = plainLight();
        light.anisotropy = g;
        light.albedo = albedo;
        const auto image = study::reference(oneRay(light, {0, 0, 5}, {0, 0, -1}));
        return image ? std::string() : image.error().message;
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double g : {1.0, -1.0, 1.5, nan})
        EXPECT_NE(message(g, {}).find("light 0 \"plain\": its anisotropy of "), std::string::npos) << g;
    for (const double albedo : {0.0, -0.1, 1.0 + 1e-12, nan})
        EXPECT_NE(message(0.0, albedo).find("light 0 \"plain\": its albedo of "), std::string::npos) << albedo;
    EXPECT_NE(message(0.0, 1e-320).find("raise the albedo"), std::string::npos);
    EXPECT_EQ(message(-0.999, 1e-9), "");
    EXPECT_EQ(message(0.999, 1.0), "");
}

}  // namespace
}  // namespace tyndall::test

// The slabs of depth that a light is drawn with: they tile its depths, follow their thickness law, stand still in the
// beam and move little when lamp or eye move little.
#include "slabs/slabs.h"

#include <gtest/gtest.h>

#include "numbers.h"
#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

PlanOptions adaptive(int slices, std::uint32_t pictureHeight = 0) {
    PlanOptions options;
    options.slices = slices;
    options.spacing = Spacing::Adaptive;
    options.pictureHeight = pictureHeight;
    return options;
}

struct Beam {
    Light light;
    View view;
    LightPose pose;
    LightVolume volume;
};

Beam beamOf(const Light& light, const View& view) {
    Beam beam{light, view, lightPose(light.worldFromLight, view.worldFromView), {}};
    ConvexPolyhedron seen;
    beam.volume = lightVolume(light, view, beam.pose, {}, {}, seen);
    return beam;
}

// Seen from anywhere, also from inside.
Beam randomBeam(Random& random) {
    Light light = projector();
    light.nearPlane = between(random, 0.01, 0.5);
    const View view = perspectiveView(rigidMotion(random, 30.0), 1.2, 1.5, 0.1, infinity);
    for (;;) {
        glm::dmat4 viewFromLight = rigidMotion(random, 4.0);
        viewFromLight[3].z -= 3.0;
        light.worldFromLight = view.worldFromView * viewFromLight;
        const Beam beam = beamOf(light, view);
        if (beam.volume.hidden == Verdict::Drawn) return beam;
    }
}

std::vector<Slab> slabsIn(const Slabs& slabs) {
    std::vector<Slab> all;
    for (int i = 0; i < slabs.count; ++i) all.push_back(slabAt(slabs, i));
    return all;
}

Slabs slabsFor(const Beam& beam, const PlanOptions& options, double detail = infinity, double visible = 0.0) {
    return slabsOf(beam.light, beam.view, options, beam.pose, beam.volume, detail, visible);
}

TEST(Slabs, TileTheVolumesDepths) {
    Random random(1);
    for (int trial = 0; trial < 2000; ++trial) {
        const Beam beam = randomBeam(random);
        PlanOptions options = adaptive(1 + static_cast<int>(random() % 200), random() % 2 ? 1080 : 0);
        if (trial % 4 == 0) options.spacing = Spacing::Even;
        const Slabs slabs = slabsFor(beam, options, std::exp(between(random, -8.0, 1.0)),
                                     random() % 2 ? between(random, 0.0, 0.1) : 0.0);
        EXPECT_LE(slabs.count, std::max(options.slices, 2));
        const double size = slabs.farDepth;
        double end = slabs.farDepth;
        for (const Slab& slab : slabsIn(slabs)) {
            EXPECT_GE(slab.thickness, 0.0);
            EXPECT_NEAR(slab.middle + 0.5 * slab.thickness, end, 1e-9 * size) << "no gap, no overlap";
            end = slab.middle - 0.5 * slab.thickness;
        }
        EXPECT_NEAR(end, slabs.nearDepth, 1e-9 * size);
        EXPECT_DOUBLE_EQ(slabs.nearDepth, beam.volume.nearDepth);
        EXPECT_DOUBLE_EQ(slabs.farDepth, beam.volume.farDepth);
    }
}

TEST(Slabs, AreNumberedTowardsTheEye) {
    Random random(2);
    for (int trial = 0; trial < 100; ++trial) {
        const Beam beam = randomBeam(random);
        const std::vector<Slab> all = slabsIn(slabsFor(beam, adaptive(64)));
        for (std::size_t i = 1; i < all.size(); ++i) EXPECT_EQ(all[i].number, all[i - 1].number + 1);
    }
}

// Minimum distance from the lamp to the pyramid's cross-section at that depth, by sampling.
double nearestOf(const Beam& beam, double depth) {
    const glm::dvec2 slope = glm::tan(0.5 * beam.light.fov);
    double min = infinity;
    for (int i = 0; i <= 200; ++i)
        for (int k = 0; k <= 200; ++k) {
            const glm::dvec3 direction(slope.x * (0.01 * i - 1.0), slope.y * (0.01 * k - 1.0), -1.0);
            const glm::dvec3 view = glm::dmat3(beam.pose.viewFromLight) * direction;
            const double axis = (depth + beam.pose.viewFromLight[3].z) / -view.z;
            if (axis > 0.0 && axis < beam.light.farPlane) min = std::min(min, axis * glm::length(direction));
        }
    return min;
}

// Of the beam, over the distance from the lamp.
double widthOf(const Light& light) {
    return 2.0 * std::tan(0.5 * std::min(light.fov.x, light.fov.y));
}

// If neither the budget nor the minimum thickness applies, interior slabs are at most as thick as growth times the
// distance of their nearest air, apart from the change of the distance within a slab.
TEST(Slabs, AreThinAsTheirDistanceFromTheLampDemands) {
    Random random(3);
    int looked = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const Beam beam = randomBeam(random);
        const double detail = std::exp(between(random, -4.0, 1.0));
        const double growth = std::min({0.2, 0.5 * detail, widthOf(beam.light) / 8.0});
        const Slabs slabs = slabsFor(beam, adaptive(65536), detail);
        for (int i = 0; i < slabs.count; i += std::max(1, slabs.count / 12)) {
            const Slab slab = slabAt(slabs, i);
            const double far = slab.middle + 0.5 * slab.thickness, near = slab.middle - 0.5 * slab.thickness;
            // h is at most hypot(growth d, growth near plane); d changes by at most secant * h over a slab.
            const double nearest = std::min(nearestOf(beam, far), nearestOf(beam, near));
            if (!std::isfinite(nearest)) continue;
            ++looked;
            const double secant = std::max(slabs.secantBefore, slabs.secantBehind);
            const double at = nearest + secant * slab.thickness;
            EXPECT_LE(slab.thickness, growth * std::hypot(at, beam.light.nearPlane) * (1.0 + 1e-6)) << trial;
        }
    }
    EXPECT_GT(looked, 300);
}

// For any resolution of the projected textures: along the beam's axis the midpoint rule integrates 1 / d^2 to a
// hundredth, whether the eye looks along the beam or into it.
TEST(Slabs, IntegrateTheInverseSquare) {
    for (const double sign : {1.0, -1.0}) {
        Light light = projector();
        light.nearPlane = 0.05;
        light.fov = glm::dvec2(1.8);  // so wide that its width sets no limit
        light.worldFromLight = lookingAt({0.0, 0.0, -10.0}, {0.0, 0.0, -10.0 - sign});
        const Slabs slabs = slabsFor(beamOf(light, wideView(glm::dmat4(1.0))), adaptive(65536));
        double sum = 0.0;
        for (const Slab& slab : slabsIn(slabs)) sum += slab.thickness / std::pow(slab.middle - 10.0, 2.0);
        const double integral = 1.0 / light.nearPlane - 1.0 / light.farPlane;
        EXPECT_NEAR(sum / integral, 1.0, 0.012) << sign;
        EXPECT_LT(slabs.count, 60);
    }
}

// Slabs need not be thinner than a pixel. A beam thinner than two pixels is a line; a quarter of a pixel is an eighth
// of it.
TEST(Slabs, AreNoThinnerThanAQuarterOfAPixelAndWhereTheBeamIsWideThanAPixel) {
    Random random(4);
    int wide = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Beam beam = randomBeam(random);
        const Slabs slabs = slabsFor(beam, adaptive(65536, 100), 1e-6);
        // Of a picture 100 high with a field of view of 1.2, at the near end of the volume.
        const double pixel = 2.0 * std::tan(0.6) / 100.0 * beam.volume.nearDepth;
        const bool isWide = widthOf(beam.light) * beam.light.nearPlane > 8.0 * pixel;
        wide += isWide;
        const double min = (isWide ? 1.0 : 0.25) * pixel;
        double thinnest = infinity;
        for (int i = 1; i + 1 < slabs.count; ++i) thinnest = std::min(thinnest, slabAt(slabs, i).thickness);
        EXPECT_GE(thinnest, min * (1.0 - 1e-9));
    }
    EXPECT_GT(wide, 20);
    EXPECT_LT(wide, 180);
}

// A narrow beam across the view, in even air: a ray through its axis meets the number of slices for the beam's width
// there.
TEST(Slabs, EightSpanTheWidthOfABeamSeenFromTheSide) {
    Light light = projector();
    light.fov = glm::dvec2(glm::radians(10.0));
    light.nearPlane = 0.3;
    light.worldFromLight = lookingAt({-3.0, 0.0, -12.0}, {1.0, 0.0, -12.0});
    const Slabs slabs = slabsFor(beamOf(light, wideView(glm::dmat4(1.0))), adaptive(65536, 2160));
    for (const double along : {0.3, 0.6, 1.2, 2.4, 4.8}) {
        const double half = 0.5 * widthOf(light) * along;
        int met = 0;
        for (const Slab& slab : slabsIn(slabs)) met += std::abs(slab.middle - 12.0) < half;
        EXPECT_GE(met, 7) << along;  // the first may begin before the beam, the last may end behind it
        EXPECT_LE(met, 60) << along;
    }
}

// The end of slab `number` towards the eye; empty if there is no such slab.
std::map<int, double> boundaries(const Slabs& slabs) {
    std::map<int, double> all;
    for (int i = 0; i + 1 < slabs.count; ++i) {  // the last one's is the volume's
        const Slab slab = slabAt(slabs, i);
        all[slab.number] = slab.middle - 0.5 * slab.thickness;
    }
    return all;
}

TEST(Slabs, StandStillInTheBeamWhileTheEyeComesNearer) {
    Light light = projector();
    light.worldFromLight = lookingAt({-2.0, 0.5, -8.0}, {1.0, 0.0, -9.0});
    std::map<int, double> before;
    for (int step = 0; step < 50; ++step) {
        glm::dmat4 eye(1.0);
        eye[3].z = -0.05 * step;
        const Beam beam = beamOf(light, perspectiveView(eye, 1.0, 1.5, 0.1, infinity));
        const Slabs slabs = slabsFor(beam, adaptive(65536), 0.05);
        std::map<int, double> now = boundaries(slabs);
        EXPECT_GT(now.size(), 20u);
        for (auto& [number, depth] : now) depth -= eye[3].z;  // world space
        for (const auto& [number, depth] : now) {
            if (before.contains(number)) {
                EXPECT_NEAR(depth, before[number], 1e-9) << number;
            }
        }
        before = now;
    }
}

// A change of the pose by a millionth changes each boundary by about as little, with or without the budget's limit, and
// also when a boundary enters or leaves at an end.
TEST(Slabs, MoveByLittleWhereThePoseDoes) {
    Random random(5);
    int bound = 0, entered = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        Beam beam = randomBeam(random);
        const PlanOptions options = adaptive(trial % 2 ? 24 : 4096, 720);
        const double detail = between(random, 0.02, 0.3);
        const Slabs first = slabsFor(beam, options, detail, 1e-3);
        bound += first.scale > 1.0;
        constexpr double tiny = 1e-6;
        glm::dmat4 moved =
            beam.light.worldFromLight * glm::mat4_cast(glm::normalize(glm::dquat(1.0, inCube(random, tiny))));
        moved[3] += glm::dvec4(inCube(random, tiny), 0.0);
        beam.light.worldFromLight = moved;
        beam = beamOf(beam.light, beam.view);
        const Slabs second = slabsFor(beam, options, detail, 1e-3);
        const std::map<int, double> before = boundaries(first), after = boundaries(second);
        // The movement of the volume's ends times the boundaries' dependence on them: the secant may be 1 / cos(89
        // degrees), and the closed form contains its derivative.
        const double allowed = 3e4 * tiny;
        for (const auto& [number, depth] : after) {
            if (before.contains(number)) {
                EXPECT_NEAR(depth, before.at(number), allowed) << trial;
            } else {
                ++entered;
                const double toEnd = std::min(std::fabs(depth - second.nearDepth), std::fabs(depth - second.farDepth));
                EXPECT_LE(toEnd, allowed) << trial;
            }
        }
    }
    EXPECT_GT(bound, 200);
    EXPECT_LT(entered, 100);
}

TEST(Slabs, AreTheSameWhereEverythingIsDrawn) {
    Random random(6);
    for (int trial = 0; trial < 50; ++trial) {
        Scene scene = randomScene(random);
        scene.light.shadow = true;
        PlanOptions options = adaptive(48, 400);
        options.displayStep = 1.0 / 256.0;
        const Plan part = planned({scene.light}, scene.view, options);
        const std::map<float, Corners> drawn = slicesOf(part, part.lights[0]);
        options.everything = true;
        const Plan whole = planned({scene.light}, scene.view, options);
        const std::map<float, Corners> all = slicesOf(whole, whole.lights[0]);
        for (const auto& [depth, corners] : drawn) EXPECT_TRUE(all.contains(depth));
        EXPECT_FALSE(drawn.empty());
    }
}

TEST(Slabs, AreNotTooManyBehindAWall) {
    // If a wall leaves a millimetre of a beam, the budget is for that millimetre. The slabs behind it, which
    // PlanOptions::everything draws, must stay limited in number.
    Beam beam = beamOf(projector(), wideView(lookingAt({0.0, 0.0, 3.0}, {0.0, 0.0, -3.0})));
    beam.volume.farLit = beam.volume.nearLit + 1e-9;
    const Slabs slabs = slabsFor(beam, adaptive(100), 1e-14);
    EXPECT_GT(slabs.count, 0);
    EXPECT_LE(slabs.count, 1 << 20);
    EXPECT_NEAR(slabAt(slabs, 0).middle + 0.5 * slabAt(slabs, 0).thickness, slabs.farDepth, 1e-9);
}

}  // namespace
}  // namespace tyndall

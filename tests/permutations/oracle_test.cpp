// The oracle against closed forms and against itself, without a GPU: the judge of the pictures needs its own proof.
#include "oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "oracle_volume.h"
#include "picture.h"
#include "scenes.h"

namespace tyndall::test {
namespace {

// A lamp at the origin of the world that looks along -Z, evenly bright, in even air.
Shot plainLamp() {
    Shot shot = withTerms(sideView(), {});
    shot.light.worldFromLight = glm::dmat4(1.0);
    shot.light.fov = {std::numbers::pi / 2, std::numbers::pi / 2};
    shot.light.nearPlane = 0.5;
    shot.light.farPlane = 4.0;
    shot.light.colour = glm::dvec3(1.0);
    shot.light.ambient = 0.0;
    shot.eye.worldFromView = lookAlong({5.0, 0.0, -2.0}, {-1.0, 0.0, 0.0});
    shot.eye.verticalFov = 0.6;
    return shot;
}

TEST(Interval, HoldsEveryFloatResult) {
    const Interval a = around(0.3, 0.1), b = around(-2.0, 0.5);
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j) {
            const float x = static_cast<float>(a.lo + (a.hi - a.lo) * i / 20.0);
            const float y = static_cast<float>(b.lo + (b.hi - b.lo) * j / 20.0);
            // The operands were rounded to binary32 as well, so they may exceed the interval by as much.
            const Interval ra = rounded(a), rb = rounded(b);
            EXPECT_TRUE((ra + rb).contains(x + y));
            EXPECT_TRUE((ra - rb).contains(x - y));
            EXPECT_TRUE((ra * rb).contains(x * y));
            EXPECT_TRUE((ra / rb).contains(x / y));
            EXPECT_TRUE(square(rb).contains(y * y));
            EXPECT_TRUE(squareRoot(ra).contains(std::sqrt(x)));
        }
}

TEST(Interval, ExactZeroStaysExact) {
    const Interval zero = exactly(0.0);
    EXPECT_EQ((zero * around(3.0, 1.0)).lo, 0.0);
    EXPECT_EQ((zero * around(3.0, 1.0)).hi, 0.0);
}

TEST(Texture, BilinearMeetsTexelsAtTheirCentresAndTheMeanBetween) {
    const Texture texture = makeTexture(4, 2, 1, [](int x, int y, int) { return x + 10 * y; });
    EXPECT_TRUE(sampleLinear(texture, 0, Address::Clamp, exactly(2.5 / 4), exactly(0.25)).contains(2.0));
    EXPECT_NEAR(sampleLinear(texture, 0, Address::Clamp, exactly(0.5), exactly(0.5)).mid(), 6.5, 1e-12);
    // Clamping repeats the first texel; wrapping puts the last one before it.
    EXPECT_NEAR(sampleLinear(texture, 0, Address::Clamp, exactly(0.0), exactly(0.25)).mid(), 0.0, 1e-12);
    EXPECT_NEAR(sampleLinear(texture, 0, Address::Wrap, exactly(0.0), exactly(0.25)).mid(), 1.5, 1e-12);
    EXPECT_NEAR(sampleLinear(texture, 0, Address::Wrap, exactly(-3.0), exactly(0.25)).mid(), 1.5, 1e-12);
}

TEST(Texture, ABoxHoldsEverySampleInIt) {
    const Texture texture = sideView().cookieMap;
    for (const double radius : {1e-5, 0.004, 0.02, 0.1})
        for (int i = 0; i < 40; ++i) {
            const double u = std::fmod(0.1 + 0.618 * i, 1.0), v = std::fmod(0.7 + 0.414 * i, 1.0);
            const Interval box = sampleLinear(texture, 1, Address::Clamp, around(u, radius), around(v, radius));
            for (int k = 0; k < 25; ++k) {
                const double du = radius * (k % 5 - 2) / 2.0, dv = radius * (k / 5 - 2) / 2.0;
                const Interval sample = sampleLinear(texture, 1, Address::Clamp, exactly(u + du), exactly(v + dv));
                EXPECT_TRUE(box.contains(sample.mid()));
            }
        }
}

TEST(Volume, CornersAndDepthsOfAPyramid) {
    const Shot shot = plainLamp();
    const auto points = corners(lightVolume(shot.light, glm::dmat4(1.0)));
    ASSERT_EQ(points.size(), 8u);
    for (const glm::dvec3& p : points) {
        EXPECT_NEAR(std::abs(p.x), -p.z, 1e-12);
        EXPECT_NEAR(std::abs(p.y), -p.z, 1e-12);
        EXPECT_LT(std::min(std::abs(p.z + 0.5), std::abs(p.z + 4.0)), 1e-12);
    }
    // From x = 5 looking along -X the pyramid, 8 m wide at its far end, reaches from 1 m to 9 m.
    const OracleImage image = oracle(shot);
    EXPECT_NEAR(image.nearDepth, 1.0, 1e-12);
    EXPECT_NEAR(image.farDepth, 9.0, 1e-12);
}

TEST(Volume, ClipPlanesCutTheDepths) {
    Shot shot = plainLamp();
    shot.light.clipPlanes = {{2.0, 0.0, 0.0, 0.0}};  // keeps x >= 0; the normal need not be of unit length
    const OracleImage image = oracle(shot);
    EXPECT_NEAR(image.nearDepth, 1.0, 1e-12);
    EXPECT_NEAR(image.farDepth, 5.0, 1e-12);
}

TEST(Volume, NearPlaneFarPlaneAndSurfaceCutTheDepths) {
    Shot shot = plainLamp();
    shot.eye.nearPlane = 2.0;
    shot.farthestSurface = 6.5;
    const OracleImage image = oracle(shot);
    EXPECT_EQ(image.nearDepth, 2.0);
    EXPECT_EQ(image.farDepth, 6.5);
}

// Along a ray that passes the lamp at distance h, the integral of I / (h^2 + t^2) from a to b is
// I (atan(b / h) - atan(a / h)) / h.
TEST(Oracle, ConvergesToTheClosedFormOfTheInverseSquareLaw) {
    Shot shot = plainLamp();
    shot.slices = 4000;
    shot.width = shot.height = 15;
    shot.eye.orthographic = true;
    shot.eye.halfHeight = 1.5;
    const OracleImage image = oracle(shot);
    // Pixel x looks along world -X at z = -2 + right: here image right is world -Z.
    for (const int x : {2, 7, 12}) {
        const double z = 2.0 + 1.5 * (2.0 * (x + 0.5) / 15.0 - 1.0);
        const double expected =
            shot.light.intensity * shot.light.density / (4.0 * std::numbers::pi) * 2.0 * std::atan(1.0) / z;
        EXPECT_NEAR(image.at(x, 7).rgba[1].mid(), expected, 2e-3 * expected) << x;
    }
}

TEST(Oracle, PerspectiveStretchesSlabsByTheRaysSlant) {
    // Even light: only ambient. A ray's share is then density / (4 pi) * ambient * its length in the volume.
    Shot shot = plainLamp();
    shot.slices = 4000;
    shot.width = shot.height = 33;
    shot.light.intensity = 0.0;
    shot.light.ambient = 3.0;
    shot.light.fov = {0.6, 2.8};  // a wide wall, edge-on to the view's vertical
    shot.eye.verticalFov = 1.6;
    const OracleImage image = oracle(shot);
    const double t = std::tan(0.8);
    for (const int y : {16, 10, 5}) {
        const double slope = t * (1.0 - 2.0 * (y + 0.5) / 33.0);
        // Between the planes x = +-2 tan(0.3) at z = -2.
        const double length = 4.0 * std::tan(0.3) * std::sqrt(1.0 + slope * slope);
        const double expected = shot.light.density / (4.0 * std::numbers::pi) * 3.0 * length;
        EXPECT_NEAR(image.at(16, y).rgba[0].mid(), expected, 2e-3 * expected) << y;
    }
}

TEST(Oracle, QuartersAddUpToTheWhole) {
    const OracleImage image = oracle(sideView());
    for (const PixelSum& pixel : image.pixels) {
        double quarters = 0.0;
        for (const auto& quarter : pixel.quarter) quarters += quarter[1].mid();
        EXPECT_NEAR(quarters, pixel.rgba[1].mid(), 1e-5 * (1e-9 + pixel.rgba[1].mid()));
    }
}

TEST(Oracle, AnEmptyShadowMapBlocksNothingAndAFullOneEverything) {
    Shot shot = withTerms(sideView(), {Term::Shadow});
    shot.shadowMap = constantTexture(8, 8, {0.0f});
    const OracleImage open = oracle(shot), without = oracle(withTerms(shot, {}));
    for (std::size_t i = 0; i < open.pixels.size(); ++i) {
        EXPECT_LE(open.pixels[i].rgba[0].lo, without.pixels[i].rgba[0].mid());
        EXPECT_GE(open.pixels[i].rgba[0].hi, without.pixels[i].rgba[0].mid());
    }
    shot.shadowMap = constantTexture(8, 8, {1.0f});
    for (const PixelSum& pixel : oracle(shot).pixels) EXPECT_EQ(pixel.rgba[0].hi, 0.0);
}

TEST(Oracle, ARigidMotionMovesNothing) {
    const glm::dmat4 motion = lookAlong({1000.0, -200.0, 31.0}, {0.3, 0.5, 0.8}, 1.1);
    const OracleImage here = oracle(sideView()), there = oracle(moved(sideView(), motion));
    for (std::size_t i = 0; i < here.pixels.size(); ++i) {
        const Interval a = here.pixels[i].rgba[0], b = there.pixels[i].rgba[0];
        EXPECT_LE(a.lo, b.hi);
        EXPECT_LE(b.lo, a.hi);
    }
}

// A tolerance that accepts everything would make all comparisons worthless: a slice's share of sixteen is 6 %, and the
// intervals, worst cases of every rounding added up, stay well below that.
TEST(Oracle, IsSharpInEveryShot) {
    for (const NamedShot& named : shots()) {
        const double vague = vagueness(allowedBy(oracle(named.shot)));
        EXPECT_GT(vague, 0.0) << named.name;
        EXPECT_LT(vague, 0.03) << named.name;
        RecordProperty(named.name, std::to_string(vague));
    }
}

}  // namespace
}  // namespace tyndall::test

// The reference against integrals that have a closed form, computed here in long double from planes in world
// space: only the formula is shared with the reference.
#include <gtest/gtest.h>

#include <cmath>

#include "oracle_volume.h"
#include "scenes.h"
#include "study_scene.h"

namespace tyndall::test {
namespace {

using Real = long double;
constexpr Real fourPi = 12.566370614359172953850573533118L;

struct Piece {
    Real begin = oneRayNear, end = 1e4L;
    bool empty() const { return !(begin < end); }
};

// Keeps the part with normal . (p + t d) + offset >= 0.
Piece cutBy(Piece piece, glm::dvec3 p, glm::dvec3 d, glm::dvec3 normal, Real offset) {
    Real at = offset, slope = 0;
    for (int i = 0; i < 3; ++i) {
        at += static_cast<Real>(normal[i]) * static_cast<Real>(p[i]);
        slope += static_cast<Real>(normal[i]) * static_cast<Real>(d[i]);
    }
    if (slope > 0) piece.begin = std::max(piece.begin, -at / slope);
    if (slope < 0) piece.end = std::min(piece.end, -at / slope);
    if (slope == 0 && at < 0) piece.end = piece.begin;
    return piece;
}

Piece inVolume(const Light& light, glm::dvec3 p, glm::dvec3 d) {
    Piece piece;
    for (const HalfSpace& plane : lightVolume(light, glm::dmat4(1.0)))
        piece = cutBy(piece, p, d, plane.normal, static_cast<Real>(plane.offset));
    return piece;
}

// Integral of I / |p + t d - lamp|^2 + ambient over the piece, times density / (4 pi).
Real scattered(const Light& light, glm::dvec3 p, glm::dvec3 d, Piece piece) {
    if (piece.empty()) return 0;
    const glm::dvec3 from = p - glm::dvec3(light.worldFromLight[3]);
    Real foot = 0, hh = 0;
    for (int i = 0; i < 3; ++i) foot -= static_cast<Real>(from[i]) * static_cast<Real>(d[i]);
    for (int i = 0; i < 3; ++i) {
        const Real across = static_cast<Real>(from[i]) + foot * static_cast<Real>(d[i]);
        hh += across * across;
    }
    const Real h = std::sqrt(hh);
    const Real lamp = (std::atan((piece.end - foot) / h) - std::atan((piece.begin - foot) / h)) / h;
    return static_cast<Real>(light.density) / fourPi *
           (static_cast<Real>(light.intensity) * lamp + static_cast<Real>(light.ambient) * (piece.end - piece.begin));
}

// The error of long doubles is about 1e-17 here; that of the reference is some 64 half-ulps of double, and one for its
// unit vectors.
constexpr double tolerance = 1e-12;

void expectNear(double value, Real exact) {
    EXPECT_NEAR(value, static_cast<double>(exact), tolerance * static_cast<double>(exact));
}

TEST(ClosedForm, UnmaskedPyramidFromAnySide) {
    Random random(1);
    int lit = 0;
    Real worst = 0;
    for (int i = 0; i < 500; ++i) {
        Light light = plainLight();
        const glm::dvec3 lamp = 3.0 * direction(random);
        light.worldFromLight = lookAlong(lamp, direction(random), uniform(random, 0.0, 6.0));
        light.ambient = uniform(random, 0.0, 2.0);
        if (i % 2 == 0) light.clipPlanes = {glm::dvec4(3.0 * direction(random), 1.0)};
        const glm::dvec3 p = lamp + uniform(random, 0.1, 6.0) * direction(random);
        const glm::dvec3 inside =
            glm::dvec3(light.worldFromLight * glm::dvec4(uniform(random, -1, 1), uniform(random, -1, 1), -2.0, 1.0));
        const glm::dvec3 d = glm::normalize(inside - p);
        const Real exact = scattered(light, p, d, inVolume(light, p, d));
        const double value = radianceOf(oneRay(light, p, d)).x;
        expectNear(value, exact);
        if (exact > 0) worst = std::max(worst, std::abs(static_cast<Real>(value) / exact - 1));
        lit += exact > 0;
    }
    EXPECT_GT(lit, 300);
    RecordProperty("largest_relative_error", std::to_string(worst * 1e15L) + "e-15");
}

// An edge at x = 0.3 in the plane 1.5 m before the lamp; all beyond it and to its right is dark.
TEST(ClosedForm, HalfSpaceOccluder) {
    Light light = plainLight();
    light.shadow = true;
    light.ambient = 0.4;
    Random random(2);
    int cut = 0;
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 p(uniform(random, -4, 4), uniform(random, -2, 2), uniform(random, -6, 2));
        const glm::dvec3 d = glm::normalize(
            glm::dvec3(uniform(random, -1.5, 1.5), uniform(random, -1, 1), uniform(random, -3.5, -0.6)) - p);
        study::ReferenceScene scene = oneRay(light, p, d);
        scene.triangles = pane({0.3, -50, -1.5}, {50, -50, -1.5}, {50, 50, -1.5}, {0.3, 50, -1.5});
        // Rays end where they meet the pane.
        Piece seen = inVolume(light, p, d);
        const double t = (-1.5 - p.z) / d.z;
        if (t > 0.0 && p.x + t * d.x > 0.3) seen.end = std::min(seen.end, static_cast<Real>(t));
        Piece dark = cutBy(seen, p, d, {0, 0, -1}, -1.5L);
        dark = cutBy(dark, p, d, {1.0, 0.0, 0.2}, 0);  // x >= 0.2 * axis
        const Real exact = scattered(light, p, d, seen) - scattered(light, p, d, dark);
        const double value = radianceOf(scene).x;
        const double whole = static_cast<double>(scattered(light, p, d, seen));
        EXPECT_NEAR(value, static_cast<double>(exact), 1e-11 * whole) << i;
        if (whole > 0.0) worst = std::max(worst, std::abs(value - static_cast<double>(exact)) / whole);
        cut += !dark.empty() && exact > 0;
    }
    EXPECT_GT(cut, 50);
    RecordProperty("largest_relative_error", std::to_string(worst * 1e15) + "e-15");
}

// A closed surface across the whole beam, of 800 triangles that share their corners: behind it the light is exactly 0.
TEST(ClosedForm, NoLightFallsThroughTheJointsOfASurface) {
    Light light = plainLight();
    light.shadow = true;
    light.fov = {1.2, 1.2};
    light.farPlane = 10.0;
    light.clipPlanes = {{0.0, 0.0, -1.0, -1.0}};
    study::ReferenceScene scene = oneRay(light, {9.0, 0.1, -5.0}, {-1.0, 0.0, 0.0});
    scene.width = 64;
    scene.height = 36;
    const auto corner = [](int i, int j) {
        return glm::dvec3(-0.71 + 1.42 * i / 20, -0.73 + 1.46 * j / 20, -0.75 + 0.01 * std::sin(i * 1.3 + j * 0.7));
    };
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j)
            for (const auto& t : pane(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)))
                scene.triangles.push_back(t);
    const auto dark = study::reference(scene);
    scene.lights[0].light.shadow = false;
    const auto open = study::reference(scene);
    ASSERT_TRUE(dark && open);
    int seen = 0;
    for (std::size_t i = 0; i < open->radiance.size(); ++i) {
        seen += open->radiance[i].x > 0.0;
        EXPECT_EQ(dark->radiance[i].x, 0.0) << i;
    }
    EXPECT_GT(seen, 500);
}

// Light falls through ever narrower slits between two panes. Doubles limit the precision of the edges, and the bound
// gives their error as a share of the small amount of light.
TEST(ClosedForm, TheBoundHoldsForASlit) {
    Light light = plainLight();
    light.shadow = true;
    light.fov = glm::dvec2(1.5);
    light.nearPlane = 0.25;
    light.farPlane = 32.0;
    for (double width = 0.0625; width > 1e-8; width *= 0.25) {
        // Along x at 16 m before the lamp; the panes stand at 1 m, their gap at x from 0.5 on.
        study::ReferenceScene scene = oneRay(light, {20.0, 0.0, -16.0}, {-1.0, 0.0, 0.0});
        scene.triangles = pane({-9, -9, -1}, {0.5, -9, -1}, {0.5, 9, -1}, {-9, 9, -1});
        for (const auto& t : pane({0.5 + width, -9, -1}, {9, -9, -1}, {9, 9, -1}, {0.5 + width, 9, -1}))
            scene.triangles.push_back(t);
        const auto image = study::reference(scene, {1e-8, 1, {}});
        ASSERT_TRUE(image);
        const Real a = 8, b = 8 + 16 * static_cast<Real>(width);  // exact in binary
        const Real angle = std::atan2(16 * (b - a), 256 + a * b);
        const Real exact = static_cast<Real>(light.density) / fourPi * static_cast<Real>(light.intensity) * angle / 16;
        const Real error = std::abs(static_cast<Real>(image->radiance[0].x) / exact - 1);
        EXPECT_LE(static_cast<double>(error), image->bound[0]) << width;
        EXPECT_LT(image->bound[0], 1e-12 / width) << width;
    }
}

// Mapped shadows, in a plane through the lamp: u is constant, so the filter's weight is one number.
TEST(ClosedForm, ShadowMapFiltersWhatItCompares) {
    Light light = plainLight();
    light.shadow = true;
    light.fov.x = 1.5707963267948966;  // u = 0.5 + x / (2 axis)
    const double blockedAt = 1.5;
    study::Image map{8, 8, 1, std::vector<float>(64, 0.0f)};
    const double stored =
        light.nearPlane * (light.farPlane - blockedAt) / (blockedAt * (light.farPlane - light.nearPlane));
    for (int y = 0; y < 8; ++y)
        for (int x = 4; x < 8; ++x) map.values[8 * y + x] = static_cast<float>(stored);
    const double reach = light.nearPlane * light.farPlane /
                         (light.nearPlane + static_cast<double>(map.values[4]) * (light.farPlane - light.nearPlane));
    for (const double u : {0.30, 0.44, 0.5, 0.53, 0.56, 0.7})
        for (const double bias : {0.0, 0.02}) {
            // From above, down through the axis, within the plane x = (2 u - 1) axis.
            const glm::dvec3 p(0.0, 1.0, 0.0), d = glm::normalize(glm::dvec3(2.0 * u - 1.0, -0.55, -1.0));
            study::ReferenceScene scene = oneRay(light, p, d);
            scene.mode = study::Mode::Hardware;
            scene.shadowBias = bias;
            scene.lights[0].shadowMap = map;
            const Piece whole = inVolume(light, p, d);
            const Piece beyond = cutBy(whole, p, d, {0, 0, -1}, -static_cast<Real>(reach + bias));
            ASSERT_FALSE(beyond.empty());
            const double open = std::clamp(1.0 - (8.0 * u - 0.5 - 3.0), 0.0, 1.0);
            expectNear(radianceOf(scene).x,
                       scattered(light, p, d, whole) - (1 - static_cast<Real>(open)) * scattered(light, p, d, beyond));
        }
}

TEST(ClosedForm, ConstantTexturesAreFactors) {
    const glm::dvec3 p(3.0, 1.0, -1.0), d = glm::normalize(glm::dvec3(-1.0, -0.4, -0.3));
    Light light = plainLight();
    light.colour = {1.0, 0.5, 0.25};
    const double plain = radianceOf(oneRay(light, p, d)).x;
    study::ReferenceScene scene = oneRay(light, p, d);
    scene.time = 12.5;
    scene.lights[0].light.cookie = true;
    scene.lights[0].cookie = {2, 2, 3, {0.5f, 0.25f, 1.0f, 0.5f, 0.25f, 1.0f, 0.5f, 0.25f, 1.0f, 0.5f, 0.25f, 1.0f}};
    scene.lights[0].light.noise = Noise{};
    scene.lights[0].light.noise->gain = 3.0;
    scene.lights[0].noise = {1, 1, 2, {0.5f, 0.75f}};
    const glm::dvec3 value = radianceOf(scene), factor = glm::dvec3(0.5, 0.25, 1.0) * 3.0 * 0.5 * 0.75;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], plain * light.colour[c] * factor[c], 1e-13 * plain) << c;
}

// Linear ramps of cookie and noise along v, in even light of ambient alone, with the axis held constant: every mask is
// a polynomial along the ray, and the integral is elementary.
TEST(ClosedForm, BilinearRamps) {
    Light light = plainLight();
    light.intensity = 0.0;
    light.ambient = 2.0;
    light.fov = {1.5707963267948966, 1.5707963267948966};
    light.cookie = true;
    Noise noise;
    noise.scale = {1.0, 1.0};
    noise.scroll1 = noise.scroll2 = {0.0, 0.0};
    noise.gain = 5.0;
    light.noise = noise;
    // At axis 2 the picture spans 4 m; v = 0.5 - y / 4 goes from 0.25 to 0.75 as y goes from 1 to -1.
    study::ReferenceScene scene = oneRay(light, {0.0, 1.0, -2.0}, {0.0, -1.0, 0.0});
    scene.lights[0].light.clipPlanes = {{0.0, 1.0, 0.0, 1.0}};
    scene.view.nearPlane = 1e-9;
    scene.lights[0].cookie = {1, 2, 3, {0.0f, 0.5f, 1.0f, 1.0f, 0.5f, 0.0f}};  // centres at v = 0.25 and 0.75
    scene.lights[0].noise = {1, 2, 2, {1.0f, 0.0f, 0.0f, 1.0f}};
    const glm::dvec3 value = radianceOf(scene, 1e-12);
    // With w in [0, 1] along 2 m: cookie (w, 1/2, 1 - w), noise 5 (1 - w) w; integrals of w^2 (1 - w) etc.
    const double base = light.density / static_cast<double>(fourPi) * light.ambient * 2.0 * 5.0;
    EXPECT_NEAR(value.r, base / 12.0, 1e-8 * base);  // the near plane's nanometre
    EXPECT_NEAR(value.g, base / 12.0, 1e-8 * base);
    EXPECT_NEAR(value.b, base / 12.0, 1e-8 * base);
}

// One channel is constant while another ramps: a cell is constant only if all channels are. From y = 1 to 0, 2 m before
// the lamp, green is (1 - y) / 2 and d^2 = 4 + y^2.
TEST(ClosedForm, EachChannelOfACookieCounts) {
    Light light = plainLight();
    light.fov = {1.5707963267948966, 1.5707963267948966};
    light.cookie = true;
    study::ReferenceScene scene = oneRay(light, {0.0, 1.0, -2.0}, {0.0, -1.0, 0.0});
    scene.lights[0].light.clipPlanes = {{0.0, 1.0, 0.0, 0.0}};
    scene.view.nearPlane = 1e-9;
    scene.lights[0].cookie = {1, 2, 3, {1.0f, 0.0f, 0.25f, 1.0f, 1.0f, 0.25f}};  // centres at v = 0.25 and 0.75
    const glm::dvec3 value = radianceOf(scene, 1e-12);
    const double base = light.density / static_cast<double>(fourPi) * light.intensity;
    const double plain = base * 0.5 * std::atan(0.5);
    EXPECT_NEAR(value.r, plain, 1e-8 * plain);  // the near plane's nanometre
    EXPECT_NEAR(value.g, 0.5 * (plain - base * 0.5 * std::log(1.25)), 1e-8 * plain);
    EXPECT_NEAR(value.b, 0.25 * plain, 1e-8 * plain);
}

// Along a line across the axis at distance 1 the cosine is 1 / sqrt(1 + x^2): with ambient alone, the squared falloff
// is made of 1 / (1 + x^2), 1 / sqrt(1 + x^2) and 1.
TEST(ClosedForm, ConeAcrossItsAxis) {
    Light light = plainLight();
    light.intensity = 0.0;
    light.ambient = 2.0;
    light.fov = glm::dvec2(2.8);
    for (const auto& [inner, outer] : {std::pair{0.3, 0.8}, {0.0, 1.0}, {0.5, 0.5}}) {
        study::ReferenceScene scene = oneRay(light, {5.0, 0.0, -1.0}, {-1.0, 0.0, 0.0});
        scene.lights[0].cone = study::Cone{inner, outer};
        const Real dark = std::cos(static_cast<Real>(outer));
        const Real width = std::max(0.001L, std::cos(static_cast<Real>(inner)) - dark);
        const Real x0 = std::sqrt(1 / ((dark + width) * (dark + width)) - 1), x1 = std::sqrt(1 / (dark * dark) - 1);
        const auto primitive = [&](Real x) { return std::atan(x) - 2 * dark * std::asinh(x) + dark * dark * x; };
        const Real length = 2 * (x0 + (primitive(x1) - primitive(x0)) / (width * width));
        // 0.001 of cosine is a difference of primitives that cancels to a thousandth squared.
        const Real exact = static_cast<Real>(light.density) / fourPi * 2 * length;
        EXPECT_NEAR(radianceOf(scene, 1e-12).x, static_cast<double>(exact), 1e-11 * static_cast<double>(exact))
            << inner;
    }
}

// Rays that graze the lamp, out to where h is no longer resolved. The limit is 1/a - 1/b.
TEST(ClosedForm, IsStableNextToTheLight) {
    Light light = plainLight();
    for (double h = 1e-2; h > 1e-17; h *= 0.1) {
        const double value = radianceOf(oneRay(light, {h, 0.0, 5.0}, {0.0, 0.0, -1.0})).x;
        const double limit = light.density / static_cast<double>(fourPi) * light.intensity * (1.0 / 0.5 - 1.0 / 4.0);
        EXPECT_NEAR(value, limit, limit * (h * h / 0.25 + 1e-12)) << h;
    }
    // On a ray through the lamp shadows are in the same place: a disc leaves the light before it.
    light.shadow = true;
    for (double h = 1e-2; h > 1e-17; h *= 0.1) {
        study::ReferenceScene scene = oneRay(light, {h, 0.0, 5.0}, {0.0, 0.0, -1.0});
        scene.triangles = pane({-1, -1, -2}, {1, -1, -2}, {1, 1, -2}, {-1, 1, -2});
        const double limit = light.density / static_cast<double>(fourPi) * light.intensity * (1.0 / 0.5 - 1.0 / 2.0);
        EXPECT_NEAR(radianceOf(scene).x, limit, limit * (h * h / 0.25 + 2e-8)) << h;
    }
}

}  // namespace
}  // namespace tyndall::test

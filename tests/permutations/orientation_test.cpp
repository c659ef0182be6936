// The orientation of textures, from the conventions alone and without the oracle: "a cookie appears as a slide would to
// an eye at the lamp looking along the light: image right is local +X, image top local +Y, the field of view spans the
// whole image".
#include <cmath>

#include "draw.h"
#include "permutation.h"

namespace tyndall::test {
namespace {

class OrientationTest : public GpuTest {};

// An eye at the lamp that sees exactly the lamp's field of view: every pixel looks along one ray of the slide.
Shot eyeAtTheLamp() {
    Shot shot = withTerms(sideView(), {});
    shot.width = 128;
    shot.height = 64;
    const double halfHeight = 0.25;
    shot.light.fov = {2.0 * std::atan(2.0 * halfHeight), 2.0 * std::atan(halfHeight)};
    shot.light.colour = {1.0, 1.0, 1.0};
    shot.eye.worldFromView = shot.light.worldFromLight;
    shot.eye.verticalFov = shot.light.fov.y;
    return shot;
}

// Ratio of two pictures at a pixel, by channel: the term's factor.
glm::dvec3 ratio(const Picture& masked, const Picture& plain, int x, int y) {
    glm::dvec3 r;
    for (int c = 0; c < 3; ++c) r[c] = static_cast<double>(masked.at(x, y)[c]) / plain.at(x, y)[c];
    return r;
}

void expectColour(glm::dvec3 actual, glm::dvec3 expected, const char* where) {
    // A few roundings in binary32; quadrants are flat, so nothing is interpolated but equal texels.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], 1e-5) << where << " channel " << c;
}

const glm::dvec3 kTopLeft{1.0, 0.125, 0.0}, kTopRight{0.0, 1.0, 0.25}, kBottomLeft{0.5, 0.0, 1.0},
    kBottomRight{0.75, 0.5, 0.375};

Texture fourQuadrants() {
    return makeTexture(32, 32, 4, [](int x, int y, int c) {
        const glm::dvec3 colour = y < 16 ? (x < 16 ? kTopLeft : kTopRight) : (x < 16 ? kBottomLeft : kBottomRight);
        return c < 3 ? colour[c] : 1.0;
    });
}

TEST_F(OrientationTest, ACookieAppearsAsASlideToAnEyeAtTheLamp) {
    const Shot plain = eyeAtTheLamp();
    Shot slide = plain;
    slide.light.cookie = true;
    slide.cookieMap = fourQuadrants();
    const Picture masked = draw(slide).sum, open = draw(plain).sum;
    expectColour(ratio(masked, open, 32, 16), kTopLeft, "top left");
    expectColour(ratio(masked, open, 96, 16), kTopRight, "top right");
    expectColour(ratio(masked, open, 32, 48), kBottomLeft, "bottom left");
    expectColour(ratio(masked, open, 96, 48), kBottomRight, "bottom right");
    // The field of view spans the image: the pixels at its very corners are still lit by the corner texels.
    expectColour(ratio(masked, open, 1, 1), kTopLeft, "top left corner");
    expectColour(ratio(masked, open, 126, 62), kBottomRight, "bottom right corner");
}

TEST_F(OrientationTest, AnEyeFacingTheLampSeesTheSlideMirrored) {
    Shot plain = eyeAtTheLamp();
    // On the axis beyond the far plane, looking back, with the same up direction.
    const glm::dmat4 frame = plain.light.worldFromLight;
    const glm::dvec3 ahead = -glm::dvec3(frame[2]);
    plain.eye.worldFromView = {-frame[0], frame[1], -frame[2],
                               glm::dvec4(glm::dvec3(frame[3]) + ahead * (plain.light.farPlane + 1.0), 1.0)};
    plain.eye.verticalFov = 2.0 * std::atan(0.3);
    Shot slide = plain;
    slide.light.cookie = true;
    slide.cookieMap = fourQuadrants();
    const Picture masked = draw(slide).sum, open = draw(plain).sum;
    // A ray stays on its side of the axis. It enters the volume a metre from the eye, where it is 0.35 m beside the
    // axis and 0.2 m above it: at the slide's scale 8 % and 9 % off the middle, more than a texel of 3 %, and the
    // distance grows from there.
    expectColour(ratio(masked, open, 101, 11), kTopLeft, "top right of the picture");
    expectColour(ratio(masked, open, 26, 11), kTopRight, "top left of the picture");
    expectColour(ratio(masked, open, 101, 52), kBottomLeft, "bottom right of the picture");
    expectColour(ratio(masked, open, 26, 52), kBottomRight, "bottom left of the picture");
}

// Red is read at uv * scale + scroll1 * time, green at uv * scale + scroll2 * time, both repeating. Red has
// vertical stripes and green horizontal ones, so a mistaken channel, phase or axis shows.
TEST_F(OrientationTest, NoiseIsGainTimesRedOfTheFirstDriftTimesGreenOfTheSecond) {
    const int size = 64;
    const auto red = [](double u) { return u < 0.25 ? 1.0 : u < 0.5 ? 0.25 : 0.5; };
    const auto green = [](double v) { return v < 0.5 ? 0.75 : 0.125; };
    const Shot plain = eyeAtTheLamp();
    Shot dusty = plain;
    dusty.noiseMap = makeTexture(
        size, size, 2, [&](int x, int y, int c) { return c == 0 ? red((x + 0.5) / size) : green((y + 0.5) / size); });
    Noise noise;
    noise.scale = {2.0, 1.0};
    noise.scroll1 = {0.03, 0.011};
    noise.scroll2 = {0.007, -0.02};
    noise.gain = 2.5;
    dusty.light.noise = noise;
    dusty.time = 14.0;  // first drift by (0.42, 0.154), second by (0.098, -0.28)
    const Picture masked = draw(dusty).sum, open = draw(plain).sum;

    const auto wrapped = [](double t) { return t - std::floor(t); };
    // Filtering blends within a texel of an edge; those places are left out.
    const auto nearEdge = [&](double t, std::initializer_list<double> edges) {
        for (const double edge : edges)
            if (std::abs(wrapped(t - edge + 0.5) - 0.5) < 1.5 / size) return true;
        return false;
    };
    int compared = 0;
    for (int y = 0; y < plain.height; ++y)
        for (int x = 0; x < plain.width; ++x) {
            const double u = (x + 0.5) / plain.width, v = (y + 0.5) / plain.height;
            const double u1 = wrapped(2.0 * u + 0.42), v2 = wrapped(v - 0.28);
            if (nearEdge(u1, {0.0, 0.25, 0.5}) || nearEdge(v2, {0.0, 0.5})) continue;
            ++compared;
            ASSERT_NEAR(ratio(masked, open, x, y)[0], 2.5 * red(u1) * green(v2), 1e-5) << x << ", " << y;
        }
    EXPECT_GT(compared, plain.width * plain.height / 2);
}

// The left half of the slide is blocked from the middle of the volume on.
TEST_F(OrientationTest, AShadowFallsBehindWhatThrowsIt) {
    const double blockedAt = 2.0;
    Shot plain = eyeAtTheLamp();
    plain.slices = 64;
    Shot shadowed = plain;
    shadowed.light.shadow = true;
    shadowed.shadowBias = 0.0;
    shadowed.shadowMap = makeTexture(32, 32, 1, [&](int x, int y, int) {
        return x < 16 && y >= 16 ? storedShadowDepth(plain.light, blockedAt) : 0.0;
    });
    const Picture masked = draw(shadowed).sum, open = draw(plain).sum;
    // Slices face the lamp here: those before the blocker count in full, those behind it count 0. Along a ray of slant
    // s, a slice at axis z has d = z s, so its share is proportional to 1 / (z s)^2 + ambient / I.
    const double n = plain.light.nearPlane, f = plain.light.farPlane, h = (f - n) / plain.slices;
    for (const auto& [x, y] : {std::pair{32, 48}, {20, 40}}) {
        const double px = (2.0 * (x + 0.5) / 128 - 1.0) * 0.5, py = (2.0 * (y + 0.5) / 64 - 1.0) * 0.25;
        const double slant2 = 1.0 + px * px + py * py;
        double lit = 0.0, all = 0.0;
        for (int i = 0; i < plain.slices; ++i) {
            const double z = n + (i + 0.5) * h;
            const double share = plain.light.intensity / (z * z * slant2) + plain.light.ambient;
            all += share;
            if (z < blockedAt) lit += share;
        }
        EXPECT_NEAR(ratio(masked, open, x, y)[0], lit / all, 2e-5);
    }
    EXPECT_EQ(ratio(masked, open, 96, 48)[0], 1.0) << "bottom right is open";
    EXPECT_EQ(ratio(masked, open, 32, 16)[0], 1.0) << "top left is open";
}

}  // namespace
}  // namespace tyndall::test

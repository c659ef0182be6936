// Whether a light needs its shadow map, cookie and noise, against random segments and texture coordinates.
#include "needs/needs.h"

#include <gtest/gtest.h>

#include "numbers.h"
#include "plan_scenes.h"
#include "visibility/walls.h"

namespace tyndall {
namespace {

std::vector<OccluderShadow> needsScratch;

using namespace test;

struct Setting {
    Light light;
    LightPose pose;
    SeenAir air;
};

// A random projector; the seen air is a box in slide and axis coordinates.
Setting randomSetting(Random& random) {
    Setting setting;
    setting.light = projector();
    setting.light.worldFromLight = rigidMotion(random, 100.0);
    setting.pose = lightPose(setting.light.worldFromLight, rigidMotion(random, 100.0));
    const glm::dvec2 slope = glm::tan(0.5 * setting.light.fov);
    const auto range = [&](double min, double max) {
        const double a = between(random, min, max), b = between(random, min, max);
        return std::pair(std::min(a, b), std::max(a, b));
    };
    SeenAir& air = setting.air;
    air.any = true;
    std::tie(air.axisNear, air.axisFar) = range(setting.light.nearPlane, setting.light.farPlane);
    std::tie(air.slopes.min.x, air.slopes.max.x) = range(-slope.x, slope.x);
    std::tie(air.slopes.min.y, air.slopes.max.y) = range(-slope.y, slope.y);
    return setting;
}

// A box with random rotation, scale and shear, near the beam.
OccluderBox randomBox(Random& random, const Light& light) {
    OccluderBox box;
    const glm::dvec3 scale(between(random, 0.3, 2.0), between(random, 0.3, 2.0), between(random, 0.3, 2.0));
    glm::dmat4 lightFromBox = rigidMotion(random, 2.0);
    for (int i = 0; i < 3; ++i) lightFromBox[i] *= scale[i];
    lightFromBox[1] += 0.3 * lightFromBox[0];
    lightFromBox[3].z -= 3.5;
    box.worldFromBox = light.worldFromLight * lightFromBox;
    const double size = between(random, 0.02, 0.8);
    box.minimum = glm::dvec3(-size);
    box.maximum = glm::dvec3(size, size, random() % 3 == 0 ? -size : size);  // some are flat
    return box;
}

OccluderSet setOf(const OccluderBox& box) {
    return OccluderSet::fromBoxes(std::span(&box, 1)).value();
}

// Position where the segment enters the box, from 0 at `from` to 1 at `to`; infinite if it misses.
double entry(const OccluderBox& box, const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dmat4 boxFromWorld = glm::inverse(box.worldFromBox);
    const glm::dvec3 a(boxFromWorld * glm::dvec4(from, 1.0)), b(boxFromWorld * glm::dvec4(to, 1.0));
    double first = 0.0, last = 1.0;
    for (int i = 0; i < 3; ++i) {
        double in = (box.minimum[i] - a[i]) / (b[i] - a[i]), out = (box.maximum[i] - a[i]) / (b[i] - a[i]);
        if (in > out) std::swap(in, out);
        first = std::max(first, in);
        last = std::min(last, out);
    }
    return first <= last ? first : infinity;
}

glm::dvec3 seenPoint(Random& random, const Setting& setting) {
    const SeenAir& air = setting.air;
    return between(random, air.axisNear, air.axisFar) * glm::dvec3(between(random, air.slopes.min.x, air.slopes.max.x),
                                                                   between(random, air.slopes.min.y, air.slopes.max.y),
                                                                   -1.0);
}

TEST(ShadowNeed, MissesNoOccluder) {
    Random random(1);
    int needed = 0, spared = 0, needless = 0, divided = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Setting setting = randomSetting(random);
        std::vector<OccluderBox> boxes;
        for (int i = 0, count = 1 + static_cast<int>(random() % 3); i < count; ++i)
            boxes.push_back(randomBox(random, setting.light));
        const OccluderSet set = OccluderSet::fromBoxes(boxes).value();
        const ShadowNeed need = shadowNeed(setting.light, setting.pose, setting.air, {}, set, 1024, needsScratch);
        bool hit = false;
        for (int i = 0; i < 300; ++i) {
            const glm::dvec3 point = seenPoint(random, setting);
            const double axis = -point.z;
            const glm::dmat4& world = setting.light.worldFromLight;
            // Occluders before the near plane throw no shadow.
            const glm::dvec3 from(world * glm::dvec4(point * (setting.light.nearPlane / axis), 1.0));
            const glm::dvec3 to(world * glm::dvec4(point, 1.0));
            for (const OccluderBox& box : boxes) {
                const double at = entry(box, from, to);
                if (at == infinity) continue;
                hit = true;
                EXPECT_TRUE(need.needed) << trial;
                const double occluder = glm::mix(setting.light.nearPlane, axis, at);
                EXPECT_LE(need.firstOccluder, occluder) << trial;
            }
        }
        needed += need.needed;
        spared += !need.needed;
        needless += need.needed && !hit;
        divided += need.needed && need.firstOccluder > setting.air.axisNear;
        EXPECT_GE(need.firstOccluder, setting.light.nearPlane);
        EXPECT_EQ(need.needed, std::isfinite(need.firstOccluder));
    }
    EXPECT_GT(needed, 300);
    EXPECT_GT(spared, 300);
    EXPECT_GT(divided, 50);
    // Fewer than one segment in 300 hits these, such as flat boxes seen edge on. Some of them may be needed, but not
    // many.
    EXPECT_LT(needless, needed / 4);
}

TEST(ShadowNeed, IsNoneWithoutOccluders) {
    Random random(2);
    const Setting setting = randomSetting(random);
    EXPECT_FALSE(shadowNeed(setting.light, setting.pose, setting.air, {}, {}, 1024, needsScratch).needed);
}

// Filtering reads a texel and a half beyond the seen air, which is wide in the coarsest map.
TEST(ShadowNeed, CountsWhatFilteringReads) {
    Setting setting;
    setting.light = projector();
    setting.pose = lightPose(setting.light.worldFromLight, glm::dmat4(1.0));
    setting.air.any = true;
    setting.air.axisNear = 1.0;
    setting.air.axisFar = 5.0;
    setting.air.slopes.min = {-0.1, -0.1};
    setting.air.slopes.max = {0.1, 0.1};
    OccluderBox box;
    // A texel of a map of 64 is 2 * tan(20 degrees) / 64 = 0.0114 wide: this begins one texel out, at 2 m.
    box.minimum = {2.0 * (0.1 + 0.0114), -0.1, -2.01};
    box.maximum = {0.5, 0.1, -2.0};
    const OccluderSet set = setOf(box);
    EXPECT_TRUE(shadowNeed(setting.light, setting.pose, setting.air, {}, set, 64, needsScratch).needed);
    EXPECT_FALSE(shadowNeed(setting.light, setting.pose, setting.air, {}, set, 1024, needsScratch).needed);
}

// A sheet x = 0.2 w - 2e-6, w the distance along the axis, that passes the lamp at 2 micrometres and behind it as well.
// A ray of slope s meets it at w = 2e-6 / (0.2 - s): beyond the near plane for every slope from -1.8 to 0.2.
TEST(ShadowNeed, HoldsBeforeTheNearestNearPlane) {
    Setting setting;
    setting.light = projector();
    setting.light.nearPlane = 1e-6;
    setting.pose = lightPose(setting.light.worldFromLight, glm::dmat4(1.0));
    const glm::dvec2 slope = glm::tan(0.5 * setting.light.fov);
    setting.air = SeenAir{true, 0.0, 0.0, 1e-6, 5.0, {-slope, slope}};
    OccluderBox box;
    const auto sheet = [](float w, float y) { return glm::vec3(0.2f * w - 2e-6f, y, -w); };
    const std::array<std::array<glm::vec3, 3>, 2> triangles{
        {{sheet(-1.0f, -2.0f), sheet(-1.0f, 2.0f), sheet(1.0f, 2.0f)},
         {sheet(-1.0f, -2.0f), sheet(1.0f, 2.0f), sheet(1.0f, -2.0f)}}};
    box.minimum = {-0.21, -2.0, -1.0};
    box.maximum = {0.21, 2.0, 1.0};
    box.triangles = triangles;
    const OccluderSet set = setOf(box);
    const ShadowNeed need = shadowNeed(setting.light, setting.pose, setting.air, {}, set, 1024, needsScratch);
    ASSERT_TRUE(need.needed);
    for (const double s : {-0.3, -0.1, 0.0, 0.1, 0.19}) {
        EXPECT_LE(need.firstOccluder, 2e-6 / (0.2 - s)) << s;
        EXPECT_TRUE(need.firstLarge <= 1.0 || (need.slopes.min.x < s && s < need.slopes.max.x)) << s;
    }
}

TEST(ShadowNeed, LeavesTheWallItselfOut) {
    Setting setting;
    setting.light = projector();
    setting.pose = lightPose(setting.light.worldFromLight, glm::dmat4(1.0));
    setting.air.any = true;
    setting.air.axisNear = 1.0;
    setting.air.axisFar = 4.0;
    setting.air.slopes.min = {-0.3, -0.2};
    setting.air.slopes.max = {0.3, 0.2};
    const glm::dvec4 walls[] = {{0.0, 0.0, 1.0, 4.0 + wallMargin(4.0)}};
    OccluderBox box;
    box.minimum = {-2.0, -2.0, -4.3};
    box.maximum = {2.0, 2.0, -4.0};
    const auto needed = [&] {
        const OccluderSet set = setOf(box);
        return shadowNeed(setting.light, setting.pose, setting.air, walls, set, 1024, needsScratch);
    };
    EXPECT_FALSE(needed().needed);
    box.maximum.z = -3.9;
    EXPECT_TRUE(needed().needed) << "stands out by a tenth of a metre";
    EXPECT_NEAR(needed().firstOccluder, 3.9, 1e-3);
}

// The cookie's value at the uv of each seen point, derived from Light's convention.
TEST(CookieRange, HoldsWhatEverySeenPointReads) {
    Random random(3);
    for (int trial = 0; trial < 200; ++trial) {
        Setting setting = randomSetting(random);
        setting.light.cookie = true;
        std::vector<glm::vec4> texels;  // 32 x 32 different greys, so cells are texels
        for (int i = 0; i < 1024; ++i) texels.push_back(glm::vec4(static_cast<float>(i)));
        const TextureSurvey survey = surveyTexture(32, 32, texels, false);
        const FactorRange range = cookieRange(setting.light, setting.air, &survey);
        const glm::dvec2 slope = glm::tan(0.5 * setting.light.fov);
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 p = seenPoint(random, setting);
            const double u = 0.5 + 0.5 * p.x / -p.z / slope.x, v = 0.5 - 0.5 * p.y / -p.z / slope.y;
            const double value = std::floor(v * 32.0) * 32.0 + std::floor(u * 32.0);  // filtering reads part of that
                                                                                      // texel
            EXPECT_LE(range.min.r, value);
            EXPECT_GE(range.max.r, value);
        }
    }
}

TEST(FactorRanges, OfWhatIsNotThereAreOneAndOfTheUnknownAreAnything) {
    Random random(4);
    const Setting setting = randomSetting(random);
    Light light = setting.light;
    EXPECT_EQ(cookieRange(light, setting.air, nullptr).min, glm::dvec3(1.0));
    EXPECT_EQ(noiseRange(light, nullptr).max, glm::dvec3(1.0));
    light.cookie = true;
    light.noise = Noise{};
    EXPECT_EQ(cookieRange(light, setting.air, nullptr).spread(), infinity);
    EXPECT_EQ(noiseRange(light, nullptr).spread(), infinity);
    light.noise->gain = 0.0;
    EXPECT_EQ(noiseRange(light, nullptr).max, glm::dvec3(0.0));
}

TEST(NoiseRange, HoldsEveryProductOfRedAndGreen) {
    Random random(5);
    for (int trial = 0; trial < 100; ++trial) {
        Light light = projector();
        light.noise = Noise{};
        light.noise->gain = between(random, 0.0, 4.0);
        std::vector<glm::vec4> texels;
        for (int i = 0; i < 64; ++i) texels.push_back(glm::vec4(glm::dvec4(inCube(random, 1.0), 1.0)));
        const TextureSurvey survey = surveyTexture(8, 8, texels, true);
        const FactorRange range = noiseRange(light, &survey);
        double min = infinity, max = -infinity;
        for (const glm::vec4& a : texels)
            for (const glm::vec4& b : texels) {
                min = std::min(min, light.noise->gain * a.r * b.g);
                max = std::max(max, light.noise->gain * a.r * b.g);
            }
        EXPECT_NEAR(range.min.x, min, 1e-6);
        EXPECT_NEAR(range.max.x, max, 1e-6);
    }
}

}  // namespace
}  // namespace tyndall

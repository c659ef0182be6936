// Laws for all scenes: halves add up, moving the world changes nothing, finer slices are closer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes.h"
#include "study_scene.h"

namespace tyndall::test {
namespace {

using study::Mode, study::ReferenceImage, study::ReferenceOptions, study::ReferenceScene;

ReferenceImage render(const ReferenceScene& scene, double accuracy = 1e-9, unsigned threads = 1) {
    ReferenceOptions options;
    options.accuracy = accuracy;
    options.threads = threads;
    auto image = study::reference(scene, options);
    if (!image) throw std::runtime_error(image.error().message);
    return std::move(*image);
}

double brightest(const ReferenceImage& image) {
    double max = 0.0;
    for (const glm::dvec3& pixel : image.radiance) max = std::max({max, pixel.r, pixel.g, pixel.b});
    return max;
}

double largestDifference(const ReferenceImage& a, const ReferenceImage& b) {
    double max = 0.0;
    for (std::size_t i = 0; i < a.radiance.size(); ++i)
        for (int c = 0; c < 3; ++c) max = std::max(max, std::abs(a.radiance[i][c] - b.radiance[i][c]));
    return max;
}

class LawsTest : public testing::TestWithParam<Mode> {};
INSTANTIATE_TEST_SUITE_P(Reference, LawsTest, testing::Values(Mode::Ideal, Mode::Hardware),
                         [](const auto& mode) { return mode.param == Mode::Ideal ? "Ideal" : "Hardware"; });

TEST_P(LawsTest, TwoHalfVolumesAddUpToTheWhole) {
    Random random(3);
    int lit = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const ReferenceScene whole = randomScene(seed, GetParam());
        const glm::dvec4 plane(direction(random), uniform(random, -0.5, 0.5));
        ReferenceScene one = whole, other = whole;
        for (auto& light : one.lights) light.light.clipPlanes.push_back(plane);
        for (auto& light : other.lights) light.light.clipPlanes.push_back(-plane);
        const ReferenceImage a = render(whole), b = render(one), c = render(other);
        ReferenceImage sum = b;
        for (std::size_t i = 0; i < sum.radiance.size(); ++i) sum.radiance[i] += c.radiance[i];
        EXPECT_LE(largestDifference(a, sum), 3e-9 * brightest(a)) << seed;
        lit += brightest(b) > 0.0 && brightest(c) > 0.0;
    }
    EXPECT_GE(lit, 6);
}

TEST_P(LawsTest, LightsAddUp) {
    int several = 0;
    for (std::uint64_t seed = 60; seed < 68; ++seed) {
        const ReferenceScene all = randomScene(seed, GetParam());
        const ReferenceImage whole = render(all);
        ReferenceImage sum = whole;
        for (glm::dvec3& pixel : sum.radiance) pixel = glm::dvec3(0.0);
        for (const auto& light : all.lights) {
            ReferenceScene one = all;
            one.lights = {light};
            const ReferenceImage image = render(one);
            for (std::size_t i = 0; i < sum.radiance.size(); ++i) sum.radiance[i] += image.radiance[i];
        }
        EXPECT_LE(largestDifference(whole, sum), 1e-15 * brightest(whole)) << seed;
        several += all.lights.size() > 1 && brightest(whole) > 0.0;
    }
    EXPECT_GE(several, 3);
}

TEST_P(LawsTest, MovingTheWorldMovesNothing) {
    int lit = 0;
    for (std::uint64_t seed = 20; seed < 30; ++seed) {
        const ReferenceScene here = randomScene(seed, GetParam());
        ReferenceScene there = here;
        const glm::dmat4 motion = lookAlong({700.0, -2000.0, 31.0}, {0.3, 0.5, 0.8}, 1.1);
        there.view.worldFromView = motion * here.view.worldFromView;
        for (auto& light : there.lights) {
            light.light.worldFromLight = motion * light.light.worldFromLight;
            for (glm::dvec4& plane : light.light.clipPlanes) plane = glm::transpose(glm::inverse(motion)) * plane;
        }
        for (auto& t : there.triangles)
            for (glm::dvec3* p : {&t.a, &t.b, &t.c}) *p = glm::dvec3(motion * glm::dvec4(*p, 1.0));
        const ReferenceImage a = render(here), b = render(there);
        // Positions 2 km out are doubles of 2e-13 m, relative to features of a few centimetres.
        EXPECT_LE(largestDifference(a, b), 1e-8 * brightest(a)) << seed;
        lit += brightest(a) > 0.0;
    }
    EXPECT_GE(lit, 5);
}

TEST_P(LawsTest, AccuracyAskedForIsAccuracyAchieved) {
    int lit = 0;
    for (std::uint64_t seed = 40; seed < 48; ++seed) {
        const ReferenceScene scene = randomScene(seed, GetParam());
        const ReferenceImage best = render(scene, 1e-12);
        std::uint64_t before = ~std::uint64_t{0};
        for (const double accuracy : {1e-10, 1e-6, 1e-3}) {
            const ReferenceImage image = render(scene, accuracy);
            // Slivers of light are only as accurate as their edges in doubles; their bounds say so, and they are few.
            const auto reached = std::count_if(image.bound.begin(), image.bound.end(),
                                               [&](double bound) { return bound <= accuracy + 1e-12; });
            EXPECT_GE(10 * reached, 9 * static_cast<std::ptrdiff_t>(image.bound.size()));
            EXPECT_EQ(image.largestBound, *std::max_element(image.bound.begin(), image.bound.end()));
            EXPECT_LE(image.evaluations, before);
            before = image.evaluations;
            for (std::size_t i = 0; i < image.radiance.size(); ++i)
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(image.radiance[i][c], best.radiance[i][c],
                                (image.bound[i] + best.bound[i]) * best.radiance[i][c]);
        }
        lit += brightest(best) > 0.0;
    }
    EXPECT_GE(lit, 4);
}

TEST_P(LawsTest, ThreadsDoNotShow) {
    const ReferenceScene scene = randomScene(50, GetParam());
    const ReferenceImage one = render(scene, 1e-8, 1), many = render(scene, 1e-8, 5);
    EXPECT_EQ(one.radiance, many.radiance);
    EXPECT_EQ(one.evaluations, many.evaluations);
}

// Slices at the middles of N slabs are the renderer's rule. With smooth masks their error falls with the square of N;
// with a shadow's edge on the ray, with N.
double sliced(const ReferenceScene& scene, int slices) {
    // One slab of light between two planes across the ray, shrunk around its middle, times the slab's length.
    double sum = 0.0;
    const glm::dvec3 eye(scene.view.worldFromView[3]), ahead = -glm::dvec3(scene.view.worldFromView[2]);
    const double begin = 3.0, end = 7.0, slab = (end - begin) / slices, thin = 1e-5 * slab;
    for (int i = 0; i < slices; ++i) {
        const double middle = begin + (i + 0.5) * slab;
        ReferenceScene one = scene;
        one.lights[0].light.clipPlanes = {{ahead, -glm::dot(ahead, eye) - middle + thin},
                                          {-ahead, glm::dot(ahead, eye) + middle + thin}};
        sum += radianceOf(one).x * slab / (2.0 * thin);
    }
    return sum;
}

TEST(Convergence, MidpointSlicesCloseInWithTheOrderOfTheory) {
    ReferenceScene scene = oneRay(plainLight(), {5.0, 0.2, -2.0}, {-1.0, 0.0, 0.0});
    scene.lights[0].light.fov.x = 2.6;  // no side of the pyramid between 3 m and 7 m
    ReferenceScene cut = scene;
    cut.lights[0].light.clipPlanes = {{-1.0, 0.0, 0.0, 2.0}, {1.0, 0.0, 0.0, 2.0}};
    const double smooth = radianceOf(cut).x;
    const double e16 = std::abs(sliced(scene, 16) - smooth), e32 = std::abs(sliced(scene, 32) - smooth);
    EXPECT_NEAR(std::log2(e16 / e32), 2.0, 0.05);

    // A pane above the ray hides x > 0.1: the error is at most one slab of the brightest air, and of that order.
    for (ReferenceScene* s : {&scene, &cut}) {
        s->lights[0].light.shadow = true;
        s->triangles = pane({0.05, -9, -1}, {9, -9, -1}, {9, 9, -1}, {0.05, 9, -1});
        s->view.nearPlane = 1e-3;
    }
    const double hard = radianceOf(cut).x;
    double worst16 = 0.0, worst64 = 0.0;
    for (int n = 16; n < 24; ++n) worst16 = std::max(worst16, n * std::abs(sliced(scene, n) - hard));
    for (int n = 64; n < 72; ++n) worst64 = std::max(worst64, n * std::abs(sliced(scene, n) - hard));
    EXPECT_GT(hard, 0.1 * smooth);
    EXPECT_LT(hard, 0.9 * smooth);
    EXPECT_NEAR(std::log2(worst16 / worst64), 0.0, 1.0);  // N times the error is constant
}

TEST(Reference, StopsWhenAsked) {
    ReferenceScene scene = randomScene(1, Mode::Ideal);
    scene.width = scene.height = 400;
    ReferenceOptions options;
    options.progress = [](double share) {
        EXPECT_GE(share, 0.0);
        EXPECT_LE(share, 1.0);
        return false;
    };
    const auto image = study::reference(scene, options);
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().message, "interrupted");
}

TEST(Reference, SaysWhatIsWrong) {
    const auto message = [](const auto& change) {
        ReferenceScene scene = randomScene(6, Mode::Hardware);
        scene.lights.resize(1);
        scene.lights[0].light.shadow = true;
        scene.lights[0].shadowMap = {2, 2, 1, {0, 0, 0, 0}};
        ReferenceOptions options;
        change(scene, options);
        const auto image = study::reference(scene, options);
        return image ? std::string() : image.error().message;
    };
    using Options = ReferenceOptions;
    EXPECT_EQ(message([](ReferenceScene&, Options&) {}), "");
    EXPECT_NE(message([](ReferenceScene& s, Options&) { s.width = 0; }).find("0x7 pixels"), std::string::npos);
    EXPECT_NE(message([](ReferenceScene&, Options& o) { o.accuracy = 0.0; }).find("1e-12"), std::string::npos);
    EXPECT_NE(message([](ReferenceScene& s, Options&) { s.lights[0].shadowMap.values.pop_back(); }).find("shadow map"),
              std::string::npos);
    EXPECT_NE(message([](ReferenceScene& s, Options&) { s.lights[0].light.farPlane = NAN; }).find("planes"),
              std::string::npos);
    EXPECT_NE(message([](ReferenceScene& s, Options&) {
                  s.lights[0].light.cookie = true, s.lights[0].cookie = {};
              }).find("cookie"),
              std::string::npos);
    const auto withNoise = [](ReferenceScene& s) {
        s.lights[0].light.noise = Noise{};
        s.lights[0].noise = {1, 1, 2, {0.5f, 0.5f}};
    };
    EXPECT_NE(message([&](ReferenceScene& s, Options&) {
                  withNoise(s), s.time = 1e300, s.lights[0].light.noise->scroll1.x = 1e10;
              }).find("scroll"),
              std::string::npos);
    EXPECT_NE(message([&](ReferenceScene& s, Options&) {
                  withNoise(s), s.lights[0].light.noise->scale.y = 1e7;
              }).find("texels"),
              std::string::npos);
    EXPECT_NE(message([](ReferenceScene& s, Options&) { s.view.clipFromView[0][0] = 0.0; }).find("invertible"),
              std::string::npos);
    EXPECT_NE(message([](ReferenceScene& s, Options&) {
                  s.triangles = {{{NAN, 0, 0}, {}, {}}};
              }).find("triangle 0"),
              std::string::npos);
    EXPECT_NE(message([](ReferenceScene& s, Options&) { s.lights[0].light.colour.g = -1.0; }).find("light 0"),
              std::string::npos);
}

}  // namespace
}  // namespace tyndall::test

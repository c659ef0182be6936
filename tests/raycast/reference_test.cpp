// Every technique of raycast.fx draws the integral, exact to the texel.
#include <gtest/gtest.h>

#include "draw.h"
#include "scenes.h"
#include "shot_reference.h"

namespace tyndall::test {
namespace {

struct Case {
    TermSet terms;
    NamedShot shot;
};

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const TermSet terms : allTermSets)
        for (const NamedShot& shot : shots()) {
            if (shot.name.starts_with("side_")) continue;  // these differ only in the number of slices
            if (shot.shot.article && terms.contains(Term::Scattering)) continue;
            const bool everyTerm = terms == TermSet::all();
            if (!everyTerm && shot.name != "side" && shot.name != "eye_inside" && shot.name != "article_look") continue;
            all.push_back({terms, shot});
        }
    return all;
}

void PrintTo(const Case& one, std::ostream* out) {
    *out << techniqueName(one.terms) << ", " << one.shot.name;
}

class RaycastReferenceTest : public GpuTest, public testing::WithParamInterface<Case> {};
INSTANTIATE_TEST_SUITE_P(RaycastFx, RaycastReferenceTest, testing::ValuesIn(cases()), [](const auto& test) {
    return std::string(techniqueName(test.param.terms)) + "_" + test.param.shot.name;
});

Drawing drawn(Shot shot, TermSet terms, Shaders shaders = Shaders::Frozen) {
    DrawOptions options;
    options.method = Method::Raycast;
    options.terms = terms;
    options.shaders = shaders;
    return draw(withTerms(std::move(shot), terms), options);
}

TEST_P(RaycastReferenceTest, DrawsTheIntegral) {
    const Shot shot = withTerms(GetParam().shot.shot, GetParam().terms);
    const Drawing drawing = drawn(GetParam().shot.shot, GetParam().terms);
    ASSERT_EQ(whyNotFinite(drawing.sum), "");
    ASSERT_EQ(drawing.plan.lights.at(0).method, Method::Raycast);
    ASSERT_EQ(drawing.plan.lights.at(0).terms, GetParam().terms);
    EXPECT_EQ(drawing.counters.draws, 1u + drawing.counters.shadowHierarchiesDrawn * 6u);  // the map has 64 texels
    const auto exact = truth(shot, drawing.plan.lights[0].farDepth - drawing.plan.lights[0].nearDepth);
    const double error = relativeL2(drawing.sum, exact);
    RecordProperty("relative_l2", std::to_string(error));
    EXPECT_LT(error, 1e-4);
}

class RaycastShaders : public GpuTest {};

// Both kinds of pipelines run the same arithmetic.
TEST_F(RaycastShaders, FrozenAndSpecializedDrawTheSamePicture) {
    for (const TermSet terms : {TermSet{}, TermSet{Term::Shadow}, TermSet{Term::Cookie}, TermSet::all()}) {
        const Drawing frozen = drawn(sideView(), terms), specialized = drawn(sideView(), terms, Shaders::Specialized);
        EXPECT_GT(litPixels(frozen.sum), 500);
        EXPECT_EQ(frozen.sum.pixels, specialized.sum.pixels) << techniqueName(terms);
    }
}

// Computed by threads or drawn by fragments, a ray is the same arithmetic. Twice the light in two parts: the second
// adds to the first.
TEST_F(RaycastShaders, ComputedAndDrawnRaysAgree) {
    for (const Accumulation accumulation : {Accumulation::Rgba32f, Accumulation::Rgba16f})
        for (const TermSet terms :
             {TermSet{}, TermSet{Term::Shadow}, TermSet{Term::Noise, Term::Cookie}, TermSet::all()}) {
            DrawOptions options;
            options.method = Method::Raycast;
            options.terms = terms;
            options.accumulation = accumulation;
            options.change = [](Plan& plan) {
                plan.parts.push_back(plan.parts.at(0));
                ++plan.groups.at(0).parts;
            };
            const Drawing once = draw(withTerms(sideView(), terms), options);
            options.storage = true;
            const Drawing computed = draw(withTerms(sideView(), terms), options);
            EXPECT_GT(litPixels(computed.sum), 500);
            EXPECT_EQ(computed.counters.draws, once.counters.draws);
            double worst = 0.0;
            for (std::size_t i = 0; i < once.sum.pixels.size(); ++i)
                for (std::size_t c = 0; c < 3; ++c) {
                    const double a = static_cast<double>(once.sum.pixels[i][c]);
                    const double b = static_cast<double>(computed.sum.pixels[i][c]);
                    if (a != b) worst = std::max(worst, std::abs(a - b) / std::max(a, b));
                }
            // One rounding of the target's format, of either of the two parts.
            EXPECT_LE(worst, accumulation == Accumulation::Rgba32f ? 1e-6 : 1.1 / 1024.0) << techniqueName(terms);
        }
}

// A routed target's four channels hold a quarter each of one grey value.
TEST_F(RaycastShaders, RoutedChannelsAddUpToTheGreyValue) {
    Shot shot = sideView();
    shot.light.colour = glm::dvec3(1.0);
    DrawOptions options;
    options.method = Method::Raycast;
    options.accumulation = Accumulation::Rgba8Routed;
    const Drawing whole = drawn(shot, TermSet::all());
    float brightest = 0.0f;
    for (const auto& pixel : whole.sum.pixels) brightest = std::max(brightest, pixel[3]);
    options.range = static_cast<double>(brightest);
    const Drawing routed = draw(shot, options);
    EXPECT_GT(litPixels(routed.sum), 300);
    for (std::size_t i = 0; i < whole.sum.pixels.size(); ++i) {
        const auto& four = routed.sum.pixels[i];
        // Each channel is rounded to a step of 1/255.
        EXPECT_NEAR((four[0] + four[1] + four[2] + four[3]) * brightest, whole.sum.pixels[i][3],
                    (4 * 0.5f / 255 + 1e-3f) * brightest);
    }
}

}  // namespace
}  // namespace tyndall::test

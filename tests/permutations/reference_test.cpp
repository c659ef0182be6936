// Tier 3: with a growing number of slices, every permutation converges to the integral.
#include "draw.h"
#include "permutation.h"
#include "shot_reference.h"

namespace tyndall::test {
namespace {

struct Case {
    Permutation permutation;
    NamedShot shot;
};

std::vector<Case> referenceCases() {
    std::vector<Case> all;
    for (const Permutation& permutation : predictedPermutations())
        for (const NamedShot& shot : shots()) {
            if (shot.name.starts_with("side_")) continue;  // these differ only in the number of slices
            if (shot.shot.article && !permutation.drawsTheArticle()) continue;
            const bool everyTerm = permutation.terms == TermSet::all();
            if (!everyTerm && shot.name != "side" && shot.name != "surface" && shot.name != "article_look") continue;
            all.push_back({permutation, {shot.name, shotFor(permutation, shot.shot)}});
        }
    return all;
}

class ReferenceTest : public GpuTest, public testing::WithParamInterface<Case> {};
INSTANTIATE_TEST_SUITE_P(SlicesFx, ReferenceTest, testing::ValuesIn(referenceCases()), [](const auto& test) {
    return test.param.permutation.name() + "_" + std::string(test.param.shot.name);
});

// Every ray begins and ends at a jump, a side of the volume or a shadow's edge, and slices at the middles of slabs miss
// a jump by up to half a slab of it (Koksma: the error is at most half a slab times the total variation). So four
// times the slices leave a quarter of the error. Not quite: a rasterizer puts corners on a grid of 1/256 pixel, and
// rays that run along a side of the volume see slices there, or not, independently of their number; so the bound of the
// second step is weaker. The test detects a factor of 1.002 anywhere, or of 1.005 with scattering, whose phase and
// transmittance make a ray's jumps up to twice as large beside its integral in these shots.
TEST_P(ReferenceTest, SlicesCloseInOnTheIntegral) {
    Shot shot = GetParam().shot.shot;
    std::vector<double> errors;
    std::vector<glm::dvec3> exact;
    for (const int slices : {100, 400, 1600}) {
        shot.slices = slices;
        const Drawing drawing = draw(shot, optionsFor(GetParam().permutation));
        ASSERT_EQ(whyNotFinite(drawing.sum), "");
        ASSERT_EQ(drawing.plan.lights.at(0).terms, GetParam().permutation.terms);
        if (exact.empty()) exact = truth(shot, drawing.plan.lights[0].farDepth - drawing.plan.lights[0].nearDepth);
        errors.push_back(relativeL2(drawing.sum, exact));
    }
    for (std::size_t i = 0; i < errors.size(); ++i)
        RecordProperty("relative_l2_" + std::to_string(i), std::to_string(errors[i]));
    const double jumps = GetParam().permutation.terms.contains(Term::Scattering) ? 2.0 : 1.0;
    EXPECT_LT(errors[0], 0.06 * jumps);
    EXPECT_LT(errors[1], errors[0] / 3.0);
    EXPECT_LT(errors[2], errors[1] / 1.9);
    EXPECT_LT(errors[2], 0.003 * jumps);
}

}  // namespace
}  // namespace tyndall::test

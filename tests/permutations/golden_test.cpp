// The approved picture of each permutation. The technique is selected by name, on a light with every term, so every
// technique of slices.fx is drawn, including those that plan() would never choose.
#include "draw.h"
#include "judge.h"

namespace tyndall::test {
namespace {

class GoldenTest : public GpuTest, public testing::WithParamInterface<Permutation> {};

INSTANTIATE_TEST_SUITE_P(SlicesFx, GoldenTest, testing::ValuesIn(permutations()), PermutationName());

struct Target {
    const char* name;
    Accumulation accumulation;
    rig::Tolerance tolerance;
};
constexpr Target kFloat{"", Accumulation::Rgba32f, rig::Tolerance::Float};

Shot smallShot(bool article) {
    Shot shot = sideView();
    shot.width = shot.height = 40;
    shot.slices = 8;
    shot.article = article;
    return shot;
}

void expectGolden(const Permutation& permutation, bool article, const Target& target) {
    DrawOptions options;
    options.drawnWith = permutation.technique->name;
    options.accumulation = target.accumulation;
    // The range stays 1: in physical units no technique's brightest pixel reaches it.
    const Drawing drawing = draw(smallShot(article), options);
    EXPECT_GT(litPixels(drawing.sum), 50);
    judgeGolden(permutation, permutation.name() + (article ? ".article" : ".physical") + target.name,
                imageOf(drawing.sum), target.tolerance);
}

TEST_P(GoldenTest, InPhysicalUnits) {
    expectGolden(GetParam(), false, kFloat);
}

TEST_P(GoldenTest, WithTheArticlesConstants) {
    expectGolden(GetParam(), true, kFloat);
}

TEST_P(GoldenTest, InFormatsOfFewerBits) {
    for (const Target& target : {Target{".rgba16f", Accumulation::Rgba16f, rig::Tolerance::Half},
                                 Target{".rgba8", Accumulation::Rgba8, rig::Tolerance::Byte},
                                 Target{".rgba8-routed", Accumulation::Rgba8Routed, rig::Tolerance::Byte}})
        expectGolden(GetParam(), false, target);
}

}  // namespace
}  // namespace tyndall::test

// What each permutation drew when somebody last looked at it. The technique is asked for by name, on a light that
// has every term: whatever slices.fx declares is drawn, also a technique that plan() would never choose.
#include "draw.h"
#include "judge.h"

namespace tyndall::test {
namespace {

class GoldenTest : public GpuTest, public testing::WithParamInterface<Permutation> {};

INSTANTIATE_TEST_SUITE_P(SlicesFx, GoldenTest, testing::ValuesIn(permutations()), PermutationName());

Shot smallShot(bool article) {
    Shot shot = sideView();
    shot.width = shot.height = 40;
    shot.slices = 8;
    shot.article = article;
    return shot;
}

void expectGolden(const Permutation& permutation, bool article) {
    DrawOptions options;
    options.drawnWith = permutation.technique->name;
    const Drawing drawing = draw(smallShot(article), options);
    EXPECT_GT(litPixels(drawing.sum), 50);
    judgeGolden(permutation, permutation.name() + (article ? ".article" : ".physical"), imageOf(drawing.sum),
                rig::Tolerance::Float);
}

TEST_P(GoldenTest, InPhysicalUnits) {
    expectGolden(GetParam(), false);
}

TEST_P(GoldenTest, WithTheArticlesConstants) {
    expectGolden(GetParam(), true);
}

}  // namespace
}  // namespace tyndall::test

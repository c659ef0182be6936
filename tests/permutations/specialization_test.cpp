// The shared module with its constants set and the frozen module without dead code draw the same picture, every time.
#include "draw.h"
#include "judge.h"

namespace tyndall::test {
namespace {

class SpecializationTest : public GpuTest, public testing::WithParamInterface<Permutation> {};

INSTANTIATE_TEST_SUITE_P(SlicesFx, SpecializationTest, testing::ValuesIn(permutations()), PermutationName());

Drawing drawByName(const Permutation& permutation, bool article, Shaders shaders) {
    Shot shot = sideView();
    shot.article = article;
    DrawOptions options;
    options.drawnWith = permutation.technique->name;
    options.shaders = shaders;
    return draw(shot, options);
}

void expectSame(const Permutation& permutation, const std::string& check, const Drawing& drawing,
                const Drawing& expected) {
    EXPECT_GT(litPixels(expected.sum), 500);
    EXPECT_EQ(whyNotFinite(expected.sum), "");
    const Image image = imageOf(drawing.sum), other = imageOf(expected.sum);
    judge(permutation, check, rig::whyDifferent(image, other, rig::Tolerance::Exact), image, &other);
}

TEST_P(SpecializationTest, DrawsWhatTheFrozenModuleDrawsBitForBit) {
    for (const bool article : {false, true})
        expectSame(GetParam(), article ? "specialized against frozen, article" : "specialized against frozen",
                   drawByName(GetParam(), article, Shaders::Specialized),
                   drawByName(GetParam(), article, Shaders::Frozen));
}

TEST_P(SpecializationTest, DrawsTheSameTwice) {
    for (const bool article : {false, true})
        for (const Shaders shaders : {Shaders::Frozen, Shaders::Specialized})
            expectSame(GetParam(),
                       std::string(shaders == Shaders::Frozen ? "frozen" : "specialized") + " run against run" +
                           (article ? ", article" : ""),
                       drawByName(GetParam(), article, shaders), drawByName(GetParam(), article, shaders));
}

// Vulkan counts what the shared module declares as used: all of it is bound, the rest to neutral textures.
TEST_P(SpecializationTest, BindsWhatTheSharedModuleDeclares) {
    DrawOptions options = optionsFor(GetParam());
    options.shaders = Shaders::Specialized;
    const Drawing drawing = draw(shotFor(GetParam(), sideView()), options);
    EXPECT_EQ(drawing.counters.descriptorsPushed, effectTables().resources.size());
}

}  // namespace
}  // namespace tyndall::test

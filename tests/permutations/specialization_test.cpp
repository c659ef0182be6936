// One module with its constants set, against a module of one's own without the dead code: the same picture.
#include "draw.h"
#include "permutation.h"

namespace tyndall::test {
namespace {

class SpecializationTest : public GpuTest, public testing::WithParamInterface<Permutation> {};

INSTANTIATE_TEST_SUITE_P(SlicesFx, SpecializationTest, testing::ValuesIn(permutations()), PermutationName());

DrawOptions withSharedModule() {
    DrawOptions options;
    options.shaders = Shaders::Specialized;
    return options;
}

TEST_P(SpecializationTest, DrawsWhatTheFrozenModuleDrawsBitForBit) {
    const Shot shot = shotFor(GetParam(), sideView());
    const Drawing frozen = draw(shot);
    const Drawing specialized = draw(shot, withSharedModule());
    ASSERT_EQ(whyNotFinite(frozen.sum), "");
    EXPECT_GT(litPixels(frozen.sum), 500);
    EXPECT_TRUE(frozen.sum.pixels == specialized.sum.pixels)
        << "largest difference " << largestDifference(frozen.sum, specialized.sum);
}

// Vulkan counts what the shared module declares as used: all of it is bound, the rest to neutral textures.
TEST_P(SpecializationTest, BindsWhatTheSharedModuleDeclares) {
    const Drawing drawing = draw(shotFor(GetParam(), sideView()), withSharedModule());
    EXPECT_EQ(drawing.counters.descriptorsPushed, 4u);
}

}  // namespace
}  // namespace tyndall::test

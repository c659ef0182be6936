// A technique has exactly the resources that its switches need.
#include <set>

#include "draw.h"
#include "permutation.h"

namespace tyndall::test {
namespace {

class LiveTest : public GpuTest, public testing::WithParamInterface<Permutation> {};

INSTANTIATE_TEST_SUITE_P(SlicesFx, LiveTest, testing::ValuesIn(permutations()), PermutationName());

std::set<std::string> samplersOf(const Permutation& permutation) {
    std::set<std::string> names;
    if (permutation.terms.contains(Term::Cookie)) names.insert("CookieSampler");
    if (permutation.terms.contains(Term::Noise)) names.insert("ScrollingNoiseSampler");
    if (permutation.terms.contains(Term::Shadow)) names.insert("ShadowMapSampler");
    return names;
}

// Other switches may need their own samplers.
TEST_P(LiveTest, ExactlyTheUniformBlockAndTheSamplersItsSwitchesCallFor) {
    std::set<std::string> samplers;
    int blocks = 0;
    for (const permgen::Resource* resource : GetParam().pass().live) {
        if (resource->kind == permgen::ResourceKind::UniformBuffer) {
            ++blocks;
        } else {
            EXPECT_TRUE(samplers.insert(std::string(resource->name)).second) << "listed twice";
            if (GetParam().predicted) {
                EXPECT_EQ(resource->dimension, permgen::ImageDimension::Two);
            }
        }
    }
    if (GetParam().predicted) {
        EXPECT_EQ(samplers, samplersOf(GetParam()));
    }
    EXPECT_EQ(blocks, 1);
}

// draw() passes null views for textures that the light lacks: validation would report a bound one.
TEST_P(LiveTest, OnlyLiveResourcesAreBound) {
    for (const bool article : {false, true}) {
        SCOPED_TRACE(article);
        Shot shot = shotFor(GetParam(), sideView());
        shot.article = article;
        const Drawing drawing = draw(shot, optionsFor(GetParam()));
        EXPECT_EQ(drawing.counters.descriptorsPushed, GetParam().pass().live.size());
        EXPECT_EQ(drawing.counters.neutralTexturesCreated, 0u);
        EXPECT_EQ(drawing.counters.draws, 1u);
        EXPECT_EQ(drawing.counters.slicesDrawn, static_cast<std::uint64_t>(drawing.plan.lights.at(0).slices));
    }
}

TEST_P(LiveTest, ItsPipelineIsMadeOnce) {
    const Shot shot = shotFor(GetParam(), sideView());
    draw(shot, optionsFor(GetParam()));
    EXPECT_EQ(draw(shot, optionsFor(GetParam())).counters.pipelinesCreated, 0u);
}

}  // namespace
}  // namespace tyndall::test

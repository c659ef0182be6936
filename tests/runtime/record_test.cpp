// Accumulation: every technique and format draws light, binds exactly its live resources, and adds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "record_scene.h"

namespace tyndall::test {
namespace {

Light lampWith(TermSet terms) {
    Light light = lamp();
    light.cookie = light.shadow = true;
    light.noise.emplace();
    return keepOnly(light, terms);
}

/// Radiance that 1 stands for in 8 bits: twice the lamp's brightest pixel.
constexpr double range = 0.0625;

Plan planFor(std::span<const Light> lights, const Stage& stage, Accumulation accumulation = Accumulation::Rgba32f) {
    PlanOptions options;
    options.slices = 16;
    options.accumulation = accumulation;
    options.shadowMapSize = 8;
    options.range = range;
    return must(plan(lights, eye(stage), options));
}

/// A group's sum in a float target.
std::vector<Rgba> accumulated(Stage& stage, const Plan& plan, const std::vector<LightTextures>& textures,
                              const ShaftTargets& targets) {
    FrameData frame;
    must(gpu().frozen.upload(frame, plan));
    run([&](VkCommandBuffer commands) {
        return gpu().frozen.recordAccumulation(commands, frame, plan, 0, textures, targets);
    });
    return texels<Rgba>(stage.accumulation, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

std::vector<Rgba> accumulated(Stage& stage, const Plan& plan, const std::vector<LightTextures>& textures) {
    return accumulated(stage, plan, textures, stage.targets());
}

std::size_t lit(const std::vector<Rgba>& picture) {
    return static_cast<std::size_t>(std::count_if(picture.begin(), picture.end(), [](const Rgba& pixel) {
        return pixel[0] > 0.0f && pixel[1] > 0.0f && pixel[2] > 0.0f;
    }));
}

bool allFinite(const std::vector<Rgba>& picture) {
    return std::all_of(picture.begin(), picture.end(), [](const Rgba& pixel) {
        return std::all_of(pixel.begin(), pixel.end(), [](float value) { return std::isfinite(value); });
    });
}

using Record = GpuTest;

class RecordEach : public GpuTest, public testing::WithParamInterface<std::tuple<std::size_t, Accumulation>> {};

TEST_P(RecordEach, DrawsFiniteLightIntoThePicture) {
    const auto& [which, accumulation] = GetParam();
    Stage stage({48, 32}, accumulation);
    const Light light = lampWith(allTermSets[which]);
    const Plan plan = planFor(std::span(&light, 1), stage, accumulation);
    ASSERT_EQ(plan.groups.size(), 1u);
    const Slides slides;
    const LightTextures textures = slides.views();
    FrameData frame;
    must(gpu().frozen.upload(frame, plan));
    run([&](VkCommandBuffer commands) {
        return gpu().frozen.record(commands, frame, plan, std::span(&textures, 1), stage.targets());
    });
    const std::vector<Rgba> picture = stage.picture();
    EXPECT_TRUE(allFinite(picture));
    // The beam covers about a third of the picture; with its left half in shadow, a good part of that.
    EXPECT_GT(lit(picture), picture.size() / 20);
    EXPECT_LT(lit(picture), picture.size() * 3 / 4);
}

std::string nameOf(const testing::TestParamInfo<std::tuple<std::size_t, Accumulation>>& info) {
    constexpr std::array formats{"rgba8", "rgba8routed", "rgba16f", "rgba32f"};
    std::string name;
    for (const Term term : allTerms)
        name += (allTermSets[std::get<0>(info.param)].contains(term) ? "" : "no") + std::string(nameOf(term)) + "_";
    return name + formats[static_cast<std::size_t>(std::get<1>(info.param))];
}

INSTANTIATE_TEST_SUITE_P(, RecordEach,
                         testing::Combine(testing::Range<std::size_t>(0, TermSet::count),
                                          testing::Values(Accumulation::Rgba8, Accumulation::Rgba8Routed,
                                                          Accumulation::Rgba16f, Accumulation::Rgba32f)),
                         nameOf);

TEST_F(Record, PushesTheLiveResourcesAndNothingElse) {
    Stage stage;
    const Slides slides;
    for (const TermSet terms : allTermSets) {
        const Light light = lampWith(terms);
        const Plan plan = planFor(std::span(&light, 1), stage);
        const RendererCounters before = gpu().frozen.counters();
        accumulated(stage, plan, {slides.views()});
        const RendererCounters& after = gpu().frozen.counters();
        EXPECT_EQ(after.descriptorsPushed - before.descriptorsPushed,
                  1u + terms.contains(Term::Noise) + terms.contains(Term::Shadow) + terms.contains(Term::Cookie))
            << techniqueName(plan.lights[0].terms);
        EXPECT_EQ(after.draws - before.draws, 1u);
        EXPECT_EQ(after.slicesDrawn - before.slicesDrawn, static_cast<std::uint64_t>(plan.lights[0].slices));
    }
}

TEST_F(Record, NeedsNoTextureThatTheTechniqueDoesNotRead) {
    Stage stage;
    const Light light = lamp();
    const Plan plan = planFor(std::span(&light, 1), stage);
    const std::uint64_t before = gpu().frozen.counters().neutralTexturesCreated;
    EXPECT_GT(lit(accumulated(stage, plan, {LightTextures{}})), 0u);
    EXPECT_EQ(gpu().frozen.counters().neutralTexturesCreated, before);
}

TEST_F(Record, StandsInForMissingTexturesOfAForcedTechnique) {
    Stage stage;
    const Light light = lamp();
    const std::vector<Rgba> plain = accumulated(stage, planFor(std::span(&light, 1), stage), {LightTextures{}});

    // Noise is left out: its neutral texture is white, and the gain alone sets the brightness.
    PlanOptions options;
    options.slices = 16;
    options.range = range;
    options.accumulation = Accumulation::Rgba32f;
    options.terms = TermSet{Term::Shadow, Term::Cookie};
    const Plan forced = must(plan(std::span(&light, 1), eye(stage), options));
    for (int repeat = 0; repeat < 2; ++repeat) EXPECT_EQ(accumulated(stage, forced, {LightTextures{}}), plain);

    options.terms = TermSet::all();
    const Plan withNoise = must(plan(std::span(&light, 1), eye(stage), options));
    EXPECT_GT(lit(accumulated(stage, withNoise, {LightTextures{}})), 0u);
    EXPECT_EQ(gpu().frozen.counters().neutralTexturesCreated, 2u);  // white and empty, once for the process
}

TEST_F(Record, MakesAPipelineOnce) {
    // Comparisons that no other test draws with.
    Stage stage;
    const Light light = lamp();
    const Plan plan = planFor(std::span(&light, 1), stage);
    ShaftTargets targets = stage.targets();
    const std::uint64_t before = gpu().frozen.counters().pipelinesCreated;
    targets.depthCompare = VK_COMPARE_OP_NOT_EQUAL;
    accumulated(stage, plan, {LightTextures{}}, targets);
    EXPECT_EQ(gpu().frozen.counters().pipelinesCreated, before + 1);
    accumulated(stage, plan, {LightTextures{}}, targets);
    EXPECT_EQ(gpu().frozen.counters().pipelinesCreated, before + 1);
    targets.depthCompare = VK_COMPARE_OP_EQUAL;
    accumulated(stage, plan, {LightTextures{}}, targets);
    EXPECT_EQ(gpu().frozen.counters().pipelinesCreated, before + 2);
}

TEST_F(Record, AddsOneLightToTheOther) {
    // Each has its own position, colour and slide.
    Stage stage;
    const Slides slides;
    std::array lights{lamp(), lamp()};
    lights[0].cookie = lights[1].cookie = true;
    lights[1].worldFromLight[3] += glm::dvec4(0.3, -0.25, 0.4, 0.0);
    lights[1].colour = {0.5, 1.0, 0.25};
    std::vector<LightTextures> textures(2);
    textures[0].cookie = slides.cookie.view();
    textures[1].cookie = slides.noise.view();
    const std::vector<Rgba> first = accumulated(stage, planFor(std::span(lights).first(1), stage), {textures[0]});
    const std::vector<Rgba> second = accumulated(stage, planFor(std::span(lights).last(1), stage), {textures[1]});
    const std::vector<Rgba> both = accumulated(stage, planFor(lights, stage), textures);
    std::size_t together = 0;
    for (std::size_t i = 0; i < both.size(); ++i) {
        together += first[i][0] > 0.0f && second[i][0] > 0.0f;
        for (int c = 0; c < 4; ++c) {
            // 32 additions in binary32: 32 half ulps of the sum, 2^-24 each.
            const float sum = first[i][c] + second[i][c];
            EXPECT_NEAR(both[i][c], sum, sum * 32.0f * 0x1p-24f) << i;
        }
    }
    EXPECT_GT(together, 50u);
}

TEST_F(Record, RoutedSumEqualsTheFloatOne) {
    const Light light = lamp();
    Stage exact({48, 32}, Accumulation::Rgba32f), routed({48, 32}, Accumulation::Rgba8Routed);
    for (Stage* stage : {&exact, &routed}) {
        const Plan plan =
            planFor(std::span(&light, 1), *stage, stage == &exact ? Accumulation::Rgba32f : Accumulation::Rgba8Routed);
        const LightTextures none;
        FrameData frame;
        must(gpu().frozen.upload(frame, plan));
        run([&](VkCommandBuffer commands) {
            return gpu().frozen.record(commands, frame, plan, std::span(&none, 1), stage->targets());
        });
    }
    const std::vector<Rgba> a = exact.picture(), b = routed.picture();
    // 16 slices, each rounded once when it is stored in 8 bits: half a step, range / 255. A rasterized share of
    // a slice is the same in both. A thousandth covers the float arithmetic.
    const auto bound = static_cast<float>(16 * 0.5 * range / 255.0 * 1.001);
    float largest = 0.0f;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(b[i][c], a[i][c], bound) << "pixel " << i << " channel " << c;
        largest = std::max(largest, a[i][0]);
    }
    EXPECT_GT(largest, 4.0f * bound);
}

TEST_F(Record, HidesWhatStandsBehindTheScene) {
    Stage stage;
    const Light light = lamp();
    const Plan plan = planFor(std::span(&light, 1), stage);
    const std::vector<Rgba> open = accumulated(stage, plan, {LightTextures{}});
    // A wall at the near plane covers the left half: depth is reversed.
    stage.setDepth([](std::uint32_t x, std::uint32_t) { return x < 24 ? 1.0f : 0.0f; });
    const std::vector<Rgba> hidden = accumulated(stage, plan, {LightTextures{}});
    std::size_t lost = 0;
    for (std::size_t i = 0; i < open.size(); ++i) {
        const bool behind = i % 48 < 24;
        EXPECT_EQ(hidden[i], behind ? Rgba{} : open[i]) << i;
        lost += behind && open[i][0] > 0.0f;
    }
    EXPECT_GT(lost, 20u);
    ShaftTargets targets = stage.targets();
    targets.depth = VK_NULL_HANDLE;
    EXPECT_EQ(accumulated(stage, plan, {LightTextures{}}, targets), open);
}

TEST_F(Record, TakesTheCallersDepthComparison) {
    Stage stage;
    const Light light = lamp();
    // The same eye with conventional depth: 0 at the near plane, 1 at the far plane.
    View view = eye(stage);
    const glm::dmat4 turnRound(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, -1, 0),
                               glm::dvec4(0, 0, 1, 1));
    view.clipFromView = turnRound * view.clipFromView;
    PlanOptions options;
    options.slices = 16;
    options.accumulation = Accumulation::Rgba32f;
    const Plan plan = must(tyndall::plan(std::span(&light, 1), view, options));
    stage.setDepth([](std::uint32_t x, std::uint32_t) { return x < 24 ? 0.0f : 1.0f; });
    ShaftTargets targets = stage.targets();
    targets.depthCompare = VK_COMPARE_OP_LESS_OR_EQUAL;
    const std::vector<Rgba> picture = accumulated(stage, plan, {LightTextures{}}, targets);
    std::size_t left = 0, right = 0;
    for (std::size_t i = 0; i < picture.size(); ++i) (i % 48 < 24 ? left : right) += picture[i][0] > 0.0f;
    EXPECT_EQ(left, 0u);
    EXPECT_GT(right, 20u);
}

TEST_F(Record, GivesEveryColourItsOwnRoutedGroup) {
    Stage stage({48, 32}, Accumulation::Rgba8Routed);
    std::array lights{lamp(), lamp()};
    lights[0].colour = {1.0, 0.0, 0.0};
    lights[1].colour = {0.0, 0.5, 1.0};
    const Plan plan = planFor(lights, stage, Accumulation::Rgba8Routed);
    ASSERT_EQ(plan.groups.size(), 2u);
    const std::array<LightTextures, 2> textures{};
    FrameData frame;
    must(gpu().frozen.upload(frame, plan));
    ShaftTargets targets = stage.targets();
    targets.blur = true;
    run([&](VkCommandBuffer commands) { return gpu().frozen.record(commands, frame, plan, textures, targets); });
    std::size_t coloured = 0;
    for (const Rgba& pixel : stage.picture()) {
        EXPECT_NEAR(pixel[1], 0.5f * pixel[2], 1e-6f);
        coloured += pixel[0] > 0.0f && pixel[2] > 0.0f;
    }
    EXPECT_GT(coloured, 50u);
}

TEST_F(Record, LeavesThePictureAloneWhereThereIsNothingToDraw) {
    Stage stage;
    stage.setColour({0.25f, 0.5f, 0.75f, 1.0f});
    const Plan plan = planFor({}, stage);
    ASSERT_TRUE(plan.groups.empty());
    FrameData frame;
    must(gpu().frozen.upload(frame, plan));
    run([&](VkCommandBuffer commands) { return gpu().frozen.record(commands, frame, plan, {}, stage.targets()); });
    for (const Rgba& pixel : stage.picture()) EXPECT_EQ(pixel, (Rgba{0.25f, 0.5f, 0.75f, 1.0f}));
    // Reading it in the documented layout must cause no validation message.
    texels<Rgba>(stage.accumulation, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

TEST_F(Record, FrameDataGrowsAndIsReused) {
    Stage stage;
    const std::array lights{lamp(), lamp(), lamp()};
    FrameData frame;
    EXPECT_EQ(frame.memory(), 0u);
    must(gpu().frozen.upload(frame, planFor(std::span(lights).first(1), stage)));
    const VkDeviceSize small = frame.memory();
    EXPECT_GT(small, 0u);
    PlanOptions options;
    options.slices = 2000;
    const Plan large = must(plan(lights, eye(stage), options));
    const std::uint64_t before = gpu().frozen.counters().bytesUploaded;
    must(gpu().frozen.upload(frame, large));
    const std::size_t bytes = large.vertices.size() * sizeof(SliceVertex) + large.indices.size() * 4;
    EXPECT_GE(gpu().frozen.counters().bytesUploaded - before, bytes + 3 * sizeof(SliceConstants));
    EXPECT_GE(frame.memory(), bytes);
    const VkDeviceSize grown = frame.memory();
    must(gpu().frozen.upload(frame, planFor(std::span(lights).first(1), stage)));
    EXPECT_EQ(frame.memory(), grown);
    FrameData moved = std::move(frame);
    EXPECT_EQ(moved.memory(), grown);
    EXPECT_EQ(frame.memory(), 0u);
    EXPECT_FALSE(gpu().frozen.upload(frame, large));
}

}  // namespace
}  // namespace tyndall::test

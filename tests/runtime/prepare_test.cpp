// Renderer::prepare(): recording then makes no pipelines, each pipeline is made once, and nothing leaks after a
// failure.
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "record_scene.h"

namespace tyndall::test {
namespace {

/// Every job runs on its own thread, all at once.
void onThreads(std::size_t count, const std::function<void(std::size_t)>& job) {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < count; ++i) threads.emplace_back([&job, i] { job(i); });
}

void twice(std::size_t count, const std::function<void(std::size_t)>& job) {
    onThreads(2 * count, [&](std::size_t i) { job(i / 2); });
}

struct LoopCase {
    const char* name;
    ParallelFor loop;
};

class Prepare : public GpuTest {
protected:
    explicit Prepare(Shaders shaders = Shaders::Frozen)
        : renderer(must(Renderer::create(context(shaders)))), terms(allTermSets.begin(), allTermSets.end()) {}

    static DeviceContext context(Shaders shaders) {
        return {gpu().device.physicalDevice(), gpu().device.device(), VK_NULL_HANDLE, shaders};
    }

    PipelineNeeds needs() const {
        const ShaftTargets targets = stage.targets();
        return {.terms = terms,
                .accumulation = Accumulation::Rgba32f,
                .depthFormat = targets.depthFormat,
                .depthCompare = targets.depthCompare,
                .colourFormat = targets.colourFormat,
                .shadowMapFormat = VK_FORMAT_D32_SFLOAT};
    }

    /// Draws a light with each technique, and a shadow map; the sum of them all.
    std::vector<Rgba> drawAll() {
        stage = Stage();
        FrameData frame;
        const Slides slides;
        const LightTextures textures = slides.views();
        const headless::Image map =
            makeImage({8, 8}, VK_FORMAT_D32_SFLOAT, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, "map");
        const Light light = lamp();
        for (const TermSet each : terms) {
            PlanOptions options;
            options.slices = 16;
            options.accumulation = Accumulation::Rgba32f;
            options.terms = each;
            const Plan planned = must(plan(std::span(&light, 1), eye(stage), options));
            must(renderer.upload(frame, planned));
            run([&](VkCommandBuffer commands) -> Result<void> {
                headless::transition(commands, map, VK_IMAGE_LAYOUT_UNDEFINED,
                                     VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
                auto drawn = renderer.recordShadowMap(commands, frame, light, {}, map.view(), map.format(), 8);
                if (!drawn) return drawn;
                return renderer.record(commands, frame, planned, std::span(&textures, 1), stage.targets());
            });
        }
        return stage.picture();
    }

    Stage stage;
    Renderer renderer;
    std::vector<TermSet> terms;
};

class PrepareBy : public Prepare, public testing::WithParamInterface<std::tuple<Shaders, LoopCase>> {
protected:
    PrepareBy() : Prepare(std::get<Shaders>(GetParam())) {}
};

TEST_P(PrepareBy, RecordingMakesNoPipelineAnyMore) {
    must(renderer.prepare(needs(), std::get<LoopCase>(GetParam()).loop));
    const RendererCounters prepared = renderer.counters();
    EXPECT_EQ(prepared.pipelinesCreated, TermSet::count + 1u + 1u);
    EXPECT_EQ(prepared.pipelinesPrepared, prepared.pipelinesCreated);
    const std::vector<Rgba> picture = drawAll();
    EXPECT_EQ(renderer.counters().pipelinesCreated, prepared.pipelinesCreated);

    // A second call has nothing to do.
    must(renderer.prepare(needs(), std::get<LoopCase>(GetParam()).loop));
    EXPECT_EQ(renderer.counters().pipelinesPrepared, prepared.pipelinesPrepared);

    renderer = must(Renderer::create(context(std::get<Shaders>(GetParam()))));
    EXPECT_TRUE(drawAll() == picture) << "the same as pipelines made when first used";
    EXPECT_EQ(renderer.counters().pipelinesCreated, prepared.pipelinesCreated);
    EXPECT_EQ(renderer.counters().pipelinesPrepared, 0u);
}

INSTANTIATE_TEST_SUITE_P(Ways, PrepareBy,
                         testing::Combine(testing::Values(Shaders::Frozen, Shaders::Specialized),
                                          testing::Values(LoopCase{"OnThisThread", {}},
                                                          LoopCase{"OnThreads", onThreads},
                                                          LoopCase{"TwiceOnThreads", twice})),
                         [](const auto& test) {
                             const bool frozen = std::get<Shaders>(test.param) == Shaders::Frozen;
                             return std::string(frozen ? "Frozen" : "Specialized") +
                                    std::get<LoopCase>(test.param).name;
                         });

TEST_F(Prepare, MakesOnlyWhatIsNeeded) {
    PipelineNeeds none = needs();
    none.terms = {};
    none.shadowMapFormat = VK_FORMAT_UNDEFINED;
    must(renderer.prepare(none, [](std::size_t, const auto&) { ADD_FAILURE() << "nothing to do in parallel"; }));
    EXPECT_EQ(renderer.counters().pipelinesCreated, 0u);

    // The same technique from many lights is made once; a second accumulation format is another pipeline.
    terms.assign(100, TermSet{Term::Shadow});
    must(renderer.prepare(needs(), onThreads));
    EXPECT_EQ(renderer.counters().pipelinesCreated, 3u);
    PipelineNeeds half = needs();
    half.accumulation = Accumulation::Rgba16f;
    must(renderer.prepare(half, onThreads));
    EXPECT_EQ(renderer.counters().pipelinesCreated, 4u);
}

TEST_F(Prepare, WhereOneFailsTheOthersAreKept) {
    PipelineNeeds wrong = needs();
    wrong.colourFormat = VK_FORMAT_R64G64B64A64_SFLOAT;
    const auto prepared = renderer.prepare(wrong, onThreads);
    ASSERT_FALSE(prepared);
    EXPECT_EQ(prepared.error().code, ErrorCode::UnsupportedDevice);
    EXPECT_EQ(renderer.counters().pipelinesCreated, TermSet::count + 1u);
    must(renderer.prepare(needs(), onThreads));
    EXPECT_EQ(renderer.counters().pipelinesCreated, TermSet::count + 2u);
}

TEST_F(Prepare, ALoopThatLeavesJobsOutIsToldSo) {
    const auto prepared = renderer.prepare(needs(), [](std::size_t count, const std::function<void(std::size_t)>& job) {
        for (std::size_t i = 0; i < count; ++i)
            if (i != 4) job(i);
        job(count);  // beyond the end: nothing happens
    });
    ASSERT_FALSE(prepared);
    EXPECT_NE(prepared.error().message.find("left out pipeline 4 of " + std::to_string(TermSet::count + 2)),
              std::string::npos);
    EXPECT_EQ(renderer.counters().pipelinesCreated, TermSet::count + 1u);
    must(renderer.prepare(needs()));
    EXPECT_EQ(renderer.counters().pipelinesCreated, TermSet::count + 2u);
}

TEST(PrepareLeak, ALoopThatThrowsOrRunsJobsTwiceLeavesNothingBehind) {
    std::vector<std::string> messages;
    {
        headless::DeviceOptions options;
        options.validation = true;
        options.preferSoftware = true;
        options.onMessage = [&](const std::string& message) { messages.push_back(message); };
        const auto device = must(headless::Device::create(options));
        auto renderer = must(Renderer::create({device.physicalDevice(), device.device()}));
        const PipelineNeeds needs{.terms = allTermSets, .accumulation = Accumulation::Rgba32f};
        const auto prepare = [&] {
            return renderer.prepare(needs, [](std::size_t, const std::function<void(std::size_t)>& job) {
                for (std::size_t i = 0; i < 3; ++i) job(i);
                throw std::runtime_error("no more threads");
            });
        };
        EXPECT_THROW((void)prepare(), std::runtime_error);
        EXPECT_EQ(renderer.counters().pipelinesCreated, 0u);
        must(renderer.prepare(needs, twice));
        EXPECT_EQ(renderer.counters().pipelinesCreated, TermSet::count);
    }
    for (const std::string& message : messages) ADD_FAILURE() << message;
}

}  // namespace
}  // namespace tyndall::test

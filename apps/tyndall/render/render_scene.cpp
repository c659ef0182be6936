#include "render_scene.h"

#include <headless/commands.h>
#include <headless/image.h>
#include <headless/statistics.h>
#include <tyndall/renderer.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>

#include "../image/tone_map.h"
#include "all_cores.h"
#include "drawn_scene.h"
#include "pass_on.h"
#include "used_images.h"

namespace tyndall::app {
namespace {

std::vector<LightTextures> lightTextures(const Scene& scene, const DrawnScene& drawn) {
    std::vector<LightTextures> textures;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const SceneLight& light = scene.lights[i];
        textures.push_back({.cookie = light.cookie ? drawn.gpu.images[*light.cookie].view() : VK_NULL_HANDLE,
                            .noise = light.noise ? drawn.gpu.images[*light.noise].view() : VK_NULL_HANDLE,
                            .shadowMap = drawn.maps.views[i]});
    }
    return textures;
}

/// Eight bits leave steps between the slices, which a blur hides.
bool isBlurred(const Plan& plan) {
    return plan.accumulation == Accumulation::Rgba8 || plan.accumulation == Accumulation::Rgba8Routed;
}

Outcome<void> drawShafts(const headless::Device& device, Renderer& renderer, FrameData& frame,
                         const PlannedScene& planned, const DrawnScene& drawn, const headless::Image& accumulation,
                         bool measure, FrameStatistics& statistics) {
    const std::vector<LightTextures> textures = lightTextures(planned.scene, drawn);
    const ShaftTargets shafts{.extent = drawn.colour.extent(),
                              .accumulation = accumulation.handle(),
                              .accumulationView = accumulation.view(),
                              .depth = drawn.depth.view(),
                              .depthFormat = depthFormat,
                              .colour = drawn.colour.view(),
                              .colourFormat = colourFormat,
                              .blur = isBlurred(planned.plan)};
    headless::FragmentCounter counter;
    statistics.fragmentsKnown = measure && device.hasPipelineStatistics();
    if (statistics.fragmentsKnown) {
        auto made = passOn(headless::FragmentCounter::create(device), "counting fragments");
        if (!made) return tl::unexpected(made.error());
        counter = std::move(*made);
    }
    for (std::size_t group = 0; group < planned.plan.groups.size(); ++group) {
        for (int round = measure ? 0 : 1; round < 2; ++round) {
            const bool counted = round == 1 && statistics.fragmentsKnown;
            const RendererCounters before = renderer.counters();
            auto added = headless::submitAndWait(device, [&](VkCommandBuffer commands) {
                if (counted) counter.begin(commands);
                auto recorded = renderer.recordAccumulation(commands, frame, planned.plan, group, textures, shafts);
                if (counted) counter.end(commands);
                return recorded;
            });
            if (!added) return fail("the shafts: {}", added.error().message);
            if (round == 0) continue;
            statistics.accumulate += *added;
            statistics.shafts.draws += renderer.counters().draws - before.draws;
            statistics.shafts.slicesDrawn += renderer.counters().slicesDrawn - before.slicesDrawn;
        }
        if (statistics.fragmentsKnown) {
            auto fragments = passOn(counter.invocations(), "counting fragments");
            if (!fragments) return tl::unexpected(fragments.error());
            statistics.fragments += *fragments;
        }
        auto composited = headless::submitAndWait(device, [&](VkCommandBuffer commands) {
            headless::fullBarrier(commands);
            return renderer.recordComposite(commands, frame, planned.plan, group, shafts);
        });
        if (!composited) return fail("the shafts: {}", composited.error().message);
        statistics.composite += *composited;
    }
    return {};
}

/// All that drawShafts() will draw with, on all cores.
Outcome<void> preparePipelines(Renderer& renderer, const Plan& plan, FrameStatistics& statistics) {
    std::vector<std::string_view> techniques;
    for (const PlannedPart& part : plan.parts) techniques.push_back(part.technique);
    const auto start = std::chrono::steady_clock::now();
    auto prepared = passOn(renderer.prepare({.techniques = techniques,
                                             .accumulation = plan.accumulation,
                                             .depthFormat = depthFormat,
                                             .colourFormat = colourFormat,
                                             .blur = isBlurred(plan)},
                                            onAllCores),
                           "the shafts");
    statistics.pipelines = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return prepared;
}

Outcome<Picture> readPicture(const headless::Device& device, const headless::Image& colour) {
    const auto bytes = headless::readback(device, colour, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    if (!bytes) return fail("the picture could not be read back: {}", bytes.error().message);
    Picture picture{.width = colour.extent().width, .height = colour.extent().height, .pixels = {}};
    picture.pixels.resize(std::size_t{picture.width} * picture.height);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        std::memcpy(&picture.pixels[i], bytes->data() + 16 * i, sizeof(glm::vec3));
    return picture;
}

/// The step that the display shows of a picture at its exposure; 0 where it shows nothing, or where nothing is shown.
double stepOf(const Picture& picture, const ShaftOptions& shafts) {
    if (!shafts.displayed) return 0.0;
    if (shafts.exposure) return displayStep(*shafts.exposure);
    const bool black = std::ranges::all_of(picture.pixels, [](const glm::vec3& p) { return p == glm::vec3(0.0f); });
    return black ? 0.0 : displayStep(automaticExposure(picture));
}

Outcome<Frame> drawFrame(const headless::Device& device, PlannedScene& planned, const ViewOptions& view,
                         const ShaftOptions& shafts, bool measure, VkPipelineCache cache, double mostStep) {
    auto renderer = Renderer::create({device.physicalDevice(), device.device(), cache});
    if (!renderer) return fail("{}", renderer.error().message);
    auto drawn = drawPlanned(device, *renderer, planned, view, shafts, cache, mostStep);
    if (!drawn) return tl::unexpected(drawn.error());
    auto accumulation = passOn(
        headless::Image::create(device, {.extent = drawn->colour.extent(),
                                         .format = accumulationFormat(shafts.accumulation),
                                         .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                                         .name = "accumulated slices"}),
        "the accumulated slices");
    if (!accumulation) return tl::unexpected(accumulation.error());

    Frame frame;
    if (auto done = preparePipelines(*renderer, planned.plan, frame.statistics); !done)
        return tl::unexpected(done.error());
    FrameData shaftData;
    const std::uint64_t uploadedBefore = renderer->counters().bytesUploaded;
    if (auto done = passOn(renderer->upload(shaftData, planned.plan), "the slices"); !done)
        return tl::unexpected(done.error());
    if (auto done = drawShafts(device, *renderer, shaftData, planned, *drawn, *accumulation, measure, frame.statistics);
        !done)
        return tl::unexpected(done.error());

    frame.statistics.shadowMaps = drawn->maps.milliseconds;
    frame.statistics.surfaces = drawn->surfaces;
    frame.statistics.shafts.pipelinesCreated = renderer->counters().pipelinesCreated;
    frame.statistics.shafts.pipelinesPrepared = renderer->counters().pipelinesPrepared;
    frame.statistics.shafts.shadowMapsDrawn = renderer->counters().shadowMapsDrawn;
    frame.statistics.shafts.bytesUploaded = renderer->counters().bytesUploaded - uploadedBefore;
    frame.statistics.shafts.descriptorsPushed = renderer->counters().descriptorsPushed;
    frame.statistics.imagesUploaded = drawn->gpu.imagesUploaded;
    frame.statistics.imageBytes = drawn->gpu.imageBytes;
    frame.statistics.surfaceDraws = drawn->surfaceDraws;
    frame.statistics.surfacePipelines = drawn->surfacePipelines;
    frame.statistics.frameDataBytes = drawn->shadowData.memory() + shaftData.memory();
    frame.statistics.deviceBytes = device.peakMemoryAllocated() + frame.statistics.frameDataBytes;
    auto picture = readPicture(device, drawn->colour);
    if (!picture) return tl::unexpected(picture.error());
    frame.picture = std::move(*picture);
    return frame;
}

}  // namespace

Outcome<DrawnScene> drawPlanned(const headless::Device& device, Renderer& renderer, PlannedScene& planned,
                                const ViewOptions& view, const ShaftOptions& shafts, VkPipelineCache cache,
                                double mostStep) {
    auto drawn = drawScene(device, renderer, planned, planned.surfaceLights, view.size, shafts.shadowSize,
                           view.layer == Layer::All, cache);
    if (!drawn) return tl::unexpected(drawn.error());
    const auto depths = readDepth(device, drawn->depth, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
    if (!depths) return tl::unexpected(depths.error());
    const auto surfaces = readPicture(device, drawn->colour);
    if (!surfaces) return tl::unexpected(surfaces.error());
    const double step = std::min(stepOf(*surfaces, shafts), mostStep);
    if (auto done = planAgain(planned, summarize(*depths, view.size, planned.view), step, view, shafts); !done)
        return tl::unexpected(done.error());
    // Only now is it known what the shafts call for.
    if (auto done = uploadImages(device, planned.scene, shaftImages(planned.scene, planned.plan), drawn->gpu); !done)
        return tl::unexpected(done.error());
    return drawn;
}

Outcome<Frame> renderScene(const headless::Device& device, PlannedScene& planned, const ViewOptions& view,
                           const ShaftOptions& shafts, bool measure, VkPipelineCache cache) {
    // What is too faint is judged by the exposure of the surfaces alone. The shafts brighten the picture, and so darken
    // its exposure, as a rule; where they do not, it is drawn again, more carefully, and at last with nothing left out.
    double mostStep = std::numeric_limits<double>::infinity();
    for (;;) {
        auto frame = drawFrame(device, planned, view, shafts, measure, cache, mostStep);
        if (!frame) return frame;
        const double step = stepOf(frame->picture, shafts);
        if (planned.displayStep <= step * (1.0 + 1e-3)) return frame;
        mostStep = std::isinf(mostStep) ? 0.5 * step : 0.0;
    }
}

}  // namespace tyndall::app

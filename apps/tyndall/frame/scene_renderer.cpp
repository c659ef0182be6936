#include "scene_renderer.h"

#include <headless/commands.h>
#include <kit/image/tone_map.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "all_cores.h"
#include "draw_shafts.h"
#include "read_back.h"
#include "used_images.h"

namespace tyndall::app {
namespace {

/// The display's step at the picture's exposure; 0 for a black picture, or if nothing is displayed.
double stepOf(const Image& picture, const ShaftOptions& shafts) {
    if (!shafts.displayed) return 0.0;
    if (shafts.exposure) return displayStep(*shafts.exposure);
    const bool black = std::ranges::all_of(picture.values, [](float value) { return value == 0.0f; });
    return black ? 0.0 : displayStep(automaticExposure(picture));
}

std::vector<std::size_t> mapsCalledFor(std::span<const SurfaceLight> surfaceLights) {
    std::vector<std::size_t> lights;
    for (std::size_t i = 0; i < surfaceLights.size(); ++i)
        if (surfaceLights[i].shadow) lights.push_back(i);
    return lights;
}

/// The slices' textures. A light with nothing in its volume needs no shadow map.
std::vector<std::size_t> mapsCalledFor(const PlannedScene& planned) {
    if (planned.options.everything) return mapsCalledFor(planned.surfaceLights);
    std::vector<std::size_t> lights;
    for (const PlannedLight& light : planned.plan.lights)
        if (light.drawn && light.terms.contains(Term::Shadow) && planned.lights[light.light].shadow &&
            !planned.instancesInLight[light.light].empty())
            lights.push_back(light.light);
    return lights;
}

}  // namespace

Result<SceneRenderer> SceneRenderer::create(const headless::Device& device, const Scene& scene, VkPipelineCache cache) {
    auto renderer = Renderer::create({device.physicalDevice(), device.device(), cache});
    if (!renderer) return tl::unexpected(renderer.error());
    auto pipelines = surfacePipelines(device, cache);
    if (!pipelines) return tl::unexpected(pipelines.error());
    auto gpu = uploadMeshes(device, scene);
    if (!gpu) return tl::unexpected(gpu.error());
    return SceneRenderer(device, std::move(*renderer), std::move(*pipelines), std::move(*gpu));
}

Result<void> SceneRenderer::drawShadowMaps(const ViewedScene& viewed, std::span<const std::size_t> lights,
                                           std::uint32_t shadowSize, bool hierarchies) {
    const auto time = maps_.draw(*device_, renderer_, viewed, lights, gpu_, shadowSize, hierarchies);
    if (!time) return tl::unexpected(time.error());
    frame_.shadowMaps += *time;
    return {};
}

Result<void> SceneRenderer::drawSurfaces(const ViewedScene& viewed, std::span<const SurfaceLight> lights, Size size,
                                         std::uint32_t shadowSize, bool lit) {
    if (auto fitted = fit(*device_, targets_, size); !fitted) return fitted;
    if (lit)
        if (auto drawn = drawShadowMaps(viewed, mapsCalledFor(lights), shadowSize, false); !drawn) return drawn;
    auto uploaded = uploadImages(*device_, viewed.scene, surfaceImages(viewed, lights, lit), gpu_);
    if (!uploaded) return uploaded;
    auto prepared = prepareSurfaces(*device_, surfacePipelines_, colourFormat, depthFormat,
                                    {viewed, lights, maps_, shadowSize, lit}, gpu_, surfaces_);
    if (!prepared) return prepared;
    const auto time = headless::submitAndWait(*device_, [&](VkCommandBuffer commands) -> Result<void> {
        headless::transition(commands, targets_.colour, VK_IMAGE_LAYOUT_UNDEFINED,
                             VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
        headless::transition(commands, targets_.depth, VK_IMAGE_LAYOUT_UNDEFINED,
                             VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
        auto recorded = recordSurfaces(commands, surfacePipelines_, surfaces_, viewed.scene, gpu_,
                                       {targets_.colour.extent(), targets_.colour.view(), targets_.depth.view()});
        headless::transition(commands, targets_.depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                             VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
        return recorded;
    });
    if (!time) return passOn(time.error(), "the surfaces");
    frame_.surfaces = *time;
    frame_.surfaceDraws = surfaces_.draws.size();
    return {};
}

Result<void> SceneRenderer::planAsDrawn(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts,
                                        double maxStep) {
    auto drawn =
        drawSurfaces(planned, planned.surfaceLights, view.size, shafts.plan.shadowMapSize, view.layer == Layer::All);
    if (!drawn) return drawn;
    const auto depths = readDepth(*device_, targets_.depth, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
    if (!depths) return tl::unexpected(depths.error());
    Image surfaces;
    if (shafts.displayed && !shafts.exposure) {
        auto read = readPicture(*device_, targets_.colour);
        if (!read) return tl::unexpected(read.error());
        surfaces = std::move(*read);
    }
    DepthSurvey depth;
    if (auto surveyed =
            passOn(surveyDepth(*depths, view.size.width, view.size.height, planned.view, depth), "the depth as drawn");
        !surveyed)
        return surveyed;
    return replanWithDepth(planned, std::move(depth), std::min(stepOf(surfaces, shafts), maxStep), view, shafts);
}

/// Makes all pipelines for drawShafts(), on all cores.
Result<void> SceneRenderer::preparePipelines(const Plan& plan) {
    std::vector<TermSet> terms;
    for (const PlannedPart& part : plan.parts) terms.push_back(part.terms);
    const auto start = std::chrono::steady_clock::now();
    auto prepared = passOn(renderer_.prepare({.terms = terms,
                                              .method = plan.parts.empty() ? Method::Slices : plan.parts[0].method,
                                              .accumulation = plan.accumulation,
                                              .depthFormat = depthFormat,
                                              .colourFormat = colourFormat,
                                              .blur = isBlurred(plan),
                                              .storage = targets_.storage},
                                             onAllCores),
                           "the shafts");
    frame_.pipelines += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return prepared;
}

Result<void> SceneRenderer::drawPlanned(PlannedScene& planned, const ShaftOptions& shafts, bool measure) {
    frame_.accumulate = frame_.composite = 0.0;
    frame_.fragments = frame_.shafts.draws = frame_.shafts.slicesDrawn = 0;
    frame_.fragmentsKnown = measure && device_->hasPipelineStatistics();
    const std::vector<bool> images = shafts.plan.everything ? std::vector<bool>(planned.scene.images.size(), true)
                                                            : shaftImages(planned.scene, planned.plan);
    if (auto uploaded = uploadImages(*device_, planned.scene, images, gpu_); !uploaded) return uploaded;
    if (auto drawn = drawShadowMaps(planned, mapsCalledFor(planned), shafts.plan.shadowMapSize,
                                    shafts.plan.method == Method::Raycast);
        !drawn)
        return drawn;
    if (planned.plan.groups.empty()) return {};
    if (auto fitted = fitAccumulation(*device_, targets_, shafts.plan); !fitted) return fitted;
    const std::vector<LightTextures> textures = texturesOf(planned, maps_, gpu_);
    if (auto prepared = preparePipelines(planned.plan); !prepared) return prepared;
    const std::uint64_t uploaded = renderer_.counters().bytesUploaded;
    if (auto done = passOn(renderer_.upload(shaftData_, planned.plan), "the slices"); !done) return done;
    if (frame_.fragmentsKnown && !counts_) {
        auto made = passOn(headless::FragmentCounter::create(*device_), "counting fragments");
        if (!made) return tl::unexpected(made.error());
        counter_ = std::move(*made);
        counts_ = true;
    }
    auto done = drawShafts(*device_, renderer_, shaftData_, planned.plan, textures, targets_, measure,
                           frame_.fragmentsKnown ? &counter_ : nullptr, frame_);
    frame_.shafts.bytesUploaded += renderer_.counters().bytesUploaded - uploaded;
    return done;
}

void SceneRenderer::startFrame() {
    maps_.startFrame();
    frame_ = {};
    before_ = {renderer_.counters(), surfacePipelines_.count(), gpu_.imagesUploaded, gpu_.imageBytes};
}

void SceneRenderer::finishStatistics() {
    const RendererCounters& now = renderer_.counters();
    const RendererCounters& then = before_.shafts;
    RendererCounters& shafts = frame_.shafts;
    shafts.pipelinesCreated = now.pipelinesCreated - then.pipelinesCreated;
    shafts.pipelinesPrepared = now.pipelinesPrepared - then.pipelinesPrepared;
    shafts.shadowMapsDrawn = now.shadowMapsDrawn - then.shadowMapsDrawn;
    shafts.descriptorsPushed = now.descriptorsPushed - then.descriptorsPushed;
    shafts.neutralTexturesCreated = now.neutralTexturesCreated - then.neutralTexturesCreated;
    frame_.surfacePipelines = surfacePipelines_.count() - before_.surfacePipelines;
    frame_.imagesUploaded = gpu_.imagesUploaded - before_.images;
    frame_.imageBytes = gpu_.imageBytes - before_.imageBytes;
    frame_.frameDataBytes = maps_.frameDataBytes() + shaftData_.memory();
    frame_.deviceBytes = device_->peakMemoryAllocated() + frame_.frameDataBytes;
}

Result<void> SceneRenderer::plan(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts) {
    startFrame();
    if (auto updated = updateSceneFacts(planned, view, shafts); !updated) return updated;
    return planAsDrawn(planned, view, shafts, std::numeric_limits<double>::infinity());
}

Result<Frame> SceneRenderer::draw(PlannedScene& planned, const ViewOptions& view, const ShaftOptions& shafts,
                                  bool measure) {
    startFrame();
    if (auto updated = updateSceneFacts(planned, view, shafts); !updated) return tl::unexpected(updated.error());
    // The plan leaves out faint light by the exposure of the surfaces only. Usually the shafts brighten the picture and
    // so lower its exposure. If not, it is drawn again with a smaller step, and finally with nothing left out.
    double maxStep = std::numeric_limits<double>::infinity();
    for (;;) {
        ++frame_.rounds;
        if (auto done = planAsDrawn(planned, view, shafts, maxStep); !done) return tl::unexpected(done.error());
        if (auto done = drawPlanned(planned, shafts, measure); !done) return tl::unexpected(done.error());
        auto picture = readPicture(*device_, targets_.colour);
        if (!picture) return tl::unexpected(picture.error());
        const double step = stepOf(*picture, shafts);
        if (planned.displayStep <= step * (1.0 + 1e-3)) {
            finishStatistics();
            return Frame{std::move(*picture), frame_};
        }
        maxStep = std::isinf(maxStep) ? 0.5 * step : 0.0;
    }
}

}  // namespace tyndall::app

#include "render_scene.h"

#include <headless/commands.h>
#include <headless/image.h>
#include <headless/statistics.h>
#include <tyndall/renderer.h>

#include <cstring>

#include "gpu_scene.h"
#include "surfaces.h"

namespace tyndall::app {
namespace {

constexpr VkFormat colourFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;
/// Depth comes back in 32 bits; the farthest surface must not lose its last slice to rounding.
constexpr double depthMargin = 1.0 + 1e-5;

struct Targets {
    headless::Image colour, depth, accumulation;
};

struct ShadowMaps {
    std::vector<headless::Image> images;
    std::vector<VkImageView> views;  ///< by light, null where it has none
};

template <class T>
Outcome<T> passOn(tl::expected<T, Error> result, const char* what) {
    if (result) return std::move(*result);
    return fail("{}: {}", what, result.error().message);
}

Outcome<void> passOn(const Result<void>& result, const char* what) {
    if (result) return {};
    return fail("{}: {}", what, result.error().message);
}

Outcome<Targets> createTargets(const headless::Device& device, VkExtent2D extent, Accumulation accumulation) {
    Targets targets;
    const auto make = [&](headless::Image& image, VkFormat format, VkImageUsageFlags usage,
                          std::string_view name) -> Outcome<void> {
        auto made = headless::Image::create(device, {.extent = extent, .format = format, .usage = usage, .name = name});
        if (!made) return fail("a picture of {}x{}: {}", extent.width, extent.height, made.error().message);
        image = std::move(*made);
        return {};
    };
    constexpr VkImageUsageFlags sampled = VK_IMAGE_USAGE_SAMPLED_BIT, source = VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    if (auto made = make(targets.colour, colourFormat, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | source, "picture"); !made)
        return tl::unexpected(made.error());
    if (auto made = make(targets.depth, depthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | sampled | source,
                         "scene depth");
        !made)
        return tl::unexpected(made.error());
    if (auto made = make(targets.accumulation, accumulationFormat(accumulation),
                         VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | sampled, "accumulated slices");
        !made)
        return tl::unexpected(made.error());
    return targets;
}

Outcome<ShadowMaps> drawShadowMaps(const headless::Device& device, Renderer& renderer, FrameData& frame,
                                   const PlannedScene& planned, const GpuScene& gpu, std::uint32_t size,
                                   double& milliseconds) {
    ShadowMaps maps;
    maps.views.resize(planned.lights.size(), VK_NULL_HANDLE);
    for (std::size_t i = 0; i < planned.lights.size(); ++i) {
        if (!planned.lights[i].shadow) continue;
        auto image = headless::Image::create(
            device, {.extent = {size, size},
                     .format = depthFormat,
                     .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                     .name = "shadow map"});
        if (!image) return fail("--shadow-size {}: {}", size, image.error().message);
        maps.views[i] = image->view();
        maps.images.push_back(std::move(*image));
    }
    const auto time = headless::submitAndWait(device, [&](VkCommandBuffer commands) -> Result<void> {
        std::size_t next = 0;
        for (std::size_t i = 0; i < planned.lights.size(); ++i) {
            if (maps.views[i] == VK_NULL_HANDLE) continue;
            const headless::Image& image = maps.images[next++];
            headless::transition(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
            auto drawn = renderer.recordShadowMap(commands, frame, planned.lights[i], gpu.occluders, image.view(),
                                                  depthFormat, size);
            if (!drawn) return drawn;
            headless::transition(commands, image, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        }
        return {};
    });
    if (!time) return fail("the shadow maps: {}", time.error().message);
    milliseconds = *time;
    return maps;
}

/// View depth of the farthest surface; unlimited where a pixel shows none.
Outcome<double> farthestSurface(const headless::Device& device, const headless::Image& depth, const View& view) {
    const auto bytes = headless::readback(device, depth, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
    if (!bytes) return fail("the scene's depth: {}", bytes.error().message);
    float farthest = 1.0f;  // reversed
    for (std::size_t i = 0; i + 4 <= bytes->size(); i += 4) {
        float value;
        std::memcpy(&value, bytes->data() + i, 4);
        farthest = std::min(farthest, value);
    }
    if (!(farthest > 0.0f)) return View{}.sceneDepth;
    const glm::dvec4 point = glm::inverse(view.clipFromView) * glm::dvec4(0.0, 0.0, farthest, 1.0);
    return std::max(-point.z / point.w * depthMargin, view.nearPlane * depthMargin);
}

std::vector<LightTextures> lightTextures(const Scene& scene, const GpuScene& gpu, const ShadowMaps& maps) {
    std::vector<LightTextures> textures;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const SceneLight& light = scene.lights[i];
        textures.push_back({.cookie = light.cookie ? gpu.images[*light.cookie].view() : VK_NULL_HANDLE,
                            .noise = light.noise ? gpu.images[*light.noise].view() : VK_NULL_HANDLE,
                            .shadowMap = maps.views[i]});
    }
    return textures;
}

Outcome<void> drawShafts(const headless::Device& device, Renderer& renderer, FrameData& frame,
                         const PlannedScene& planned, const std::vector<LightTextures>& textures,
                         const Targets& targets, bool measure, FrameStatistics& statistics) {
    const bool eightBits =
        planned.plan.accumulation == Accumulation::Rgba8 || planned.plan.accumulation == Accumulation::Rgba8Routed;
    const ShaftTargets shafts{.extent = targets.colour.extent(),
                              .accumulation = targets.accumulation.handle(),
                              .accumulationView = targets.accumulation.view(),
                              .depth = targets.depth.view(),
                              .depthFormat = depthFormat,
                              .colour = targets.colour.view(),
                              .colourFormat = colourFormat,
                              .blur = eightBits};
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

Outcome<Picture> readPicture(const headless::Device& device, const headless::Image& colour) {
    const auto bytes = headless::readback(device, colour, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    if (!bytes) return fail("the picture could not be read back: {}", bytes.error().message);
    Picture picture{.width = colour.extent().width, .height = colour.extent().height, .pixels = {}};
    picture.pixels.resize(std::size_t{picture.width} * picture.height);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        std::memcpy(&picture.pixels[i], bytes->data() + 16 * i, sizeof(glm::vec3));
    return picture;
}

}  // namespace

Outcome<Frame> renderScene(const headless::Device& device, PlannedScene& planned, const ViewOptions& view,
                           const ShaftOptions& shafts, bool measure) {
    auto renderer = Renderer::create({device.physicalDevice(), device.device(), VK_NULL_HANDLE});
    if (!renderer) return fail("{}", renderer.error().message);
    auto gpu = uploadScene(device, planned.scene);
    if (!gpu) return tl::unexpected(gpu.error());
    auto targets = createTargets(device, {view.size.width, view.size.height}, shafts.accumulation);
    if (!targets) return tl::unexpected(targets.error());

    Frame frame;
    FrameData shadowData, shaftData;
    auto maps =
        drawShadowMaps(device, *renderer, shadowData, planned, *gpu, shafts.shadowSize, frame.statistics.shadowMaps);
    if (!maps) return tl::unexpected(maps.error());

    auto pipelines = surfacePipelines(device);
    if (!pipelines) return tl::unexpected(pipelines.error());
    auto surfaces = prepareSurfaces(device, *pipelines, colourFormat, depthFormat, planned.scene, *gpu, planned.view,
                                    planned.lights, maps->views, shafts.shadowSize, view.layer == Layer::All);
    if (!surfaces) return tl::unexpected(surfaces.error());
    const auto drawn = headless::submitAndWait(device, [&](VkCommandBuffer commands) -> Result<void> {
        headless::transition(commands, targets->colour, VK_IMAGE_LAYOUT_UNDEFINED,
                             VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
        headless::transition(commands, targets->depth, VK_IMAGE_LAYOUT_UNDEFINED,
                             VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
        auto recorded = recordSurfaces(commands, *pipelines, *surfaces, planned.scene, *gpu,
                                       {targets->colour.extent(), targets->colour.view(), targets->depth.view()});
        headless::transition(commands, targets->depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                             VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
        return recorded;
    });
    if (!drawn) return fail("the surfaces: {}", drawn.error().message);
    frame.statistics.surfaces = *drawn;

    const auto depth = farthestSurface(device, targets->depth, planned.view);
    if (!depth) return tl::unexpected(depth.error());
    if (auto done = planAgain(planned, *depth, view, shafts); !done) return tl::unexpected(done.error());
    if (auto done = passOn(renderer->upload(shaftData, planned.plan), "the slices"); !done)
        return tl::unexpected(done.error());
    if (auto done = drawShafts(device, *renderer, shaftData, planned, lightTextures(planned.scene, *gpu, *maps),
                               *targets, measure, frame.statistics);
        !done)
        return tl::unexpected(done.error());

    frame.statistics.shafts.pipelinesCreated = renderer->counters().pipelinesCreated;
    frame.statistics.shafts.bytesUploaded = renderer->counters().bytesUploaded;
    frame.statistics.surfaceDraws = surfaces->draws.size();
    frame.statistics.surfacePipelines = pipelines->count();
    frame.statistics.frameDataBytes = shadowData.memory() + shaftData.memory();
    frame.statistics.deviceBytes = device.peakMemoryAllocated() + frame.statistics.frameDataBytes;
    auto picture = readPicture(device, targets->colour);
    if (!picture) return tl::unexpected(picture.error());
    frame.picture = std::move(*picture);
    return frame;
}

}  // namespace tyndall::app

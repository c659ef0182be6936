#include "draw.h"

#include <headless/commands.h>

#include <cstring>
#include <glm/gtc/packing.hpp>

namespace tyndall::test {
namespace {

constexpr VkFormat kPictureFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

std::size_t bytesOf(Accumulation accumulation) {
    switch (accumulation) {
        case Accumulation::Rgba8:
        case Accumulation::Rgba8Routed:
            return 4;
        case Accumulation::Rgba16f:
            return 8;
        case Accumulation::Rgba32f:
            return 16;
    }
    return 0;
}

std::array<float, 4> decode(const std::byte* texel, Accumulation accumulation) {
    std::array<float, 4> value{};
    if (accumulation == Accumulation::Rgba32f) {
        std::memcpy(value.data(), texel, sizeof value);
    } else if (accumulation == Accumulation::Rgba16f) {
        std::array<std::uint16_t, 4> half{};
        std::memcpy(half.data(), texel, sizeof half);
        for (int c = 0; c < 4; ++c) value[c] = glm::unpackHalf1x16(half[c]);
    } else {
        for (int c = 0; c < 4; ++c) value[c] = static_cast<float>(std::to_integer<int>(texel[c])) / 255.0f;
    }
    return value;
}

Picture download(const headless::Image& image, VkImageLayout layout, Accumulation format) {
    const std::vector<std::byte> bytes = must(headless::readback(gpu().device, image, layout));
    Picture picture{static_cast<int>(image.extent().width), static_cast<int>(image.extent().height), {}};
    const std::size_t step = bytesOf(format);
    for (std::size_t at = 0; at + step <= bytes.size(); at += step)
        picture.pixels.push_back(decode(bytes.data() + at, format));
    return picture;
}

void fillBackground(VkCommandBuffer commands, const headless::Image& picture) {
    headless::transition(commands, picture, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkClearColorValue value{};
    std::copy(kBackground.begin(), kBackground.end(), value.float32);
    const VkImageSubresourceRange whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdClearColorImage(commands, picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &value, 1, &whole);
    headless::transition(commands, picture, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                         VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
}

// Images that stay alive until the picture is read.
struct Textures {
    headless::Image cookie, noise, shadowMap, hierarchy;
    LightTextures views;
};

Textures texturesOf(const Shot& shot, Method method) {
    Textures textures;
    if (shot.light.cookie) {
        textures.cookie = uploadTexture(shot.cookieMap);
        textures.views.cookie = textures.cookie.view();
        textures.views.cookieSize = textures.cookie.extent();
    }
    if (shot.light.noise) {
        textures.noise = uploadTexture(shot.noiseMap);
        textures.views.noise = textures.noise.view();
        textures.views.noiseSize = textures.noise.extent();
    }
    if (shot.light.shadow) {
        textures.shadowMap = uploadTexture(shot.shadowMap, true);
        textures.views.shadowMap = textures.shadowMap.view();
        if (method == Method::Raycast) {
            textures.hierarchy = shadowHierarchyImage(textures.shadowMap.extent().width);
            textures.views.shadowHierarchy = textures.hierarchy.view();
        }
    }
    return textures;
}

headless::Image colourTarget(const Shot& shot, VkFormat format, VkImageUsageFlags usage, std::string_view name) {
    headless::ImageInfo info;
    info.extent = {static_cast<std::uint32_t>(shot.width), static_cast<std::uint32_t>(shot.height)};
    info.format = format;
    info.usage = usage;
    info.name = name;
    return must(headless::Image::create(gpu().device, info));
}

}  // namespace

RendererCounters difference(const RendererCounters& after, const RendererCounters& before) {
    RendererCounters delta;
    delta.draws = after.draws - before.draws;
    delta.slicesDrawn = after.slicesDrawn - before.slicesDrawn;
    delta.descriptorsPushed = after.descriptorsPushed - before.descriptorsPushed;
    delta.pipelinesCreated = after.pipelinesCreated - before.pipelinesCreated;
    delta.bytesUploaded = after.bytesUploaded - before.bytesUploaded;
    delta.neutralTexturesCreated = after.neutralTexturesCreated - before.neutralTexturesCreated;
    delta.shadowHierarchiesDrawn = after.shadowHierarchiesDrawn - before.shadowHierarchiesDrawn;
    delta.shadowMapsDrawn = after.shadowMapsDrawn - before.shadowMapsDrawn;
    delta.pipelinesPrepared = after.pipelinesPrepared - before.pipelinesPrepared;
    return delta;
}

headless::Image shadowHierarchyImage(std::uint32_t mapSize) {
    headless::ImageInfo info;
    info.extent = {shadowHierarchySide(mapSize), shadowHierarchySide(mapSize)};
    info.format = shadowHierarchyFormat;
    info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    info.name = "shadow hierarchy";
    info.levels = shadowHierarchyLevels(mapSize);
    return must(headless::Image::create(gpu().device, info));
}

ShadowHierarchy levelsOf(const headless::Image& image, const VkImageView& whole) {
    return {image.handle(), image.levels().empty() ? std::span(&whole, 1) : std::span(image.levels())};
}

View viewOf(const Shot& shot) {
    const Eye& eye = shot.eye;
    const double aspect = static_cast<double>(shot.width) / shot.height;
    View view =
        eye.orthographic
            ? orthographicView(eye.worldFromView, eye.halfHeight * aspect, eye.halfHeight, eye.nearPlane, eye.farPlane)
            : perspectiveView(eye.worldFromView, eye.verticalFov, aspect, eye.nearPlane, eye.farPlane);
    view.sceneDepth = shot.farthestSurface;
    return view;
}

PlanOptions planOptionsOf(const Shot& shot, const DrawOptions& options) {
    PlanOptions plan;
    plan.method = options.method;
    plan.slices = shot.slices;
    plan.geometry = options.geometry;
    plan.accumulation = options.accumulation;
    plan.look = shot.article ? Look::Article : Look::Physical;
    plan.time = shot.time;
    plan.range = options.range;
    plan.shadowMapSize = static_cast<std::uint32_t>(shot.shadowMap.width);
    plan.shadowBias = shot.shadowBias;
    plan.terms = options.terms;
    return plan;
}

Drawing draw(const Shot& shot, const DrawOptions& options) {
    Gpu& g = gpu();
    Drawing drawing;
    drawing.plan = must(plan(std::span(&shot.light, 1), viewOf(shot), planOptionsOf(shot, options)));
    if (const auto terms = options.drawnWith ? termsOf(*options.drawnWith) : std::nullopt) {
        for (PlannedLight& light : drawing.plan.lights) light.terms = *terms;
        for (PlannedPart& part : drawing.plan.parts) part.terms = *terms;
    }
    if (options.change) options.change(drawing.plan);
    Renderer& renderer = options.drawnWith && !termsOf(*options.drawnWith)
                             ? g.rendererFor(*options.drawnWith, options.shaders)
                             : (options.shaders == Shaders::Frozen ? g.frozen : g.specialized);

    const Textures textures = texturesOf(shot, options.method);
    const Texture depthTexels =
        shot.sceneDepth.texels.empty() ? constantTexture(shot.width, shot.height, {0.0f}) : shot.sceneDepth;
    const headless::Image depth = uploadTexture(depthTexels, true, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
    const headless::Image sum = colourTarget(shot, accumulationFormat(options.accumulation),
                                             VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                                 VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                                 (options.storage ? VkImageUsageFlags{VK_IMAGE_USAGE_STORAGE_BIT} : 0u),
                                             "sum");
    const headless::Image colour = colourTarget(
        shot, kPictureFormat,
        VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
        "picture");
    ShaftTargets targets;
    targets.extent = sum.extent();
    targets.accumulation = sum.handle();
    targets.accumulationView = sum.view();
    targets.storage = options.storage;
    targets.depth = depth.view();
    targets.depthFormat = depth.format();
    targets.colour = colour.view();
    targets.colourFormat = colour.format();
    targets.blur = options.blur;

    const RendererCounters before = renderer.counters();
    FrameData frame;
    must(renderer.upload(frame, drawing.plan));
    // Nothing to draw leaves no group: the sum is then black by definition.
    const bool empty = drawing.plan.groups.empty();
    must(headless::submitAndWait(g.device, [&](VkCommandBuffer commands) -> Result<void> {
        fillBackground(commands, colour);
        if (empty) return {};
        const std::span views(&textures.views, 1);
        Result<void> done;
        if (textures.hierarchy.handle())
            done = renderer.recordShadowHierarchy(commands, frame, textures.views.shadowMap,
                                                  textures.shadowMap.extent().width,
                                                  levelsOf(textures.hierarchy, textures.views.shadowHierarchy));
        if (done) done = renderer.recordAccumulation(commands, frame, drawing.plan, 0, views, targets);
        if (done && options.composite) done = renderer.recordComposite(commands, frame, drawing.plan, 0, targets);
        return done;
    }));
    drawing.counters = difference(renderer.counters(), before);
    drawing.picture = download(colour, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, Accumulation::Rgba32f);
    drawing.sum = empty ? Picture{shot.width, shot.height, decltype(Picture::pixels)(drawing.picture.pixels.size())}
                        : download(sum, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, options.accumulation);
    return drawing;
}

}  // namespace tyndall::test

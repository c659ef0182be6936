#include "draw.h"

#include <headless/commands.h>

#include <cstring>
#include <glm/gtc/packing.hpp>

namespace tyndall::test {
namespace {

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

Picture decodePicture(const std::vector<std::byte>& bytes, const Shot& shot, Accumulation accumulation) {
    Picture picture{shot.width, shot.height, {}};
    const std::size_t step = bytesOf(accumulation);
    for (std::size_t at = 0; at + step <= bytes.size(); at += step)
        picture.pixels.push_back(decode(bytes.data() + at, accumulation));
    return picture;
}

// Images that stay alive until the picture is read.
struct Textures {
    headless::Image cookie, noise, shadowMap;
    LightTextures views;
};

Textures texturesOf(const Shot& shot) {
    Textures textures;
    if (shot.light.cookie) {
        textures.cookie = uploadTexture(shot.cookieMap);
        textures.views.cookie = textures.cookie.view();
    }
    if (shot.light.noise) {
        textures.noise = uploadTexture(shot.noiseMap);
        textures.views.noise = textures.noise.view();
    }
    if (shot.light.shadow) {
        textures.shadowMap = uploadTexture(shot.shadowMap, true);
        textures.views.shadowMap = textures.shadowMap.view();
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

RendererCounters difference(const RendererCounters& after, const RendererCounters& before) {
    return {after.draws - before.draws, after.slicesDrawn - before.slicesDrawn,
            after.descriptorsPushed - before.descriptorsPushed, after.pipelinesCreated - before.pipelinesCreated,
            after.bytesUploaded - before.bytesUploaded};
}

}  // namespace

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
    plan.slices = shot.slices;
    plan.geometry = options.geometry;
    plan.accumulation = options.accumulation;
    plan.look = shot.article ? Look::Article : Look::Physical;
    plan.time = shot.time;
    plan.range = options.range;
    plan.shadowMapSize = static_cast<std::uint32_t>(shot.shadowMap.width);
    plan.shadowBias = shot.shadowBias;
    plan.technique = options.technique;
    return plan;
}

Drawing draw(const Shot& shot, const DrawOptions& options) {
    Gpu& g = gpu();
    Drawing drawing;
    drawing.plan = must(plan(std::span(&shot.light, 1), viewOf(shot), planOptionsOf(shot, options)));

    const Textures textures = texturesOf(shot);
    const Texture depthTexels =
        shot.sceneDepth.texels.empty() ? constantTexture(shot.width, shot.height, {0.0f}) : shot.sceneDepth;
    const headless::Image depth = uploadTexture(depthTexels, true, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
    const headless::Image sum = colourTarget(
        shot, accumulationFormat(options.accumulation),
        VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT, "sum");
    const headless::Image colour =
        colourTarget(shot, VK_FORMAT_R32G32B32A32_SFLOAT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, "colour");
    ShaftTargets targets;
    targets.extent = sum.extent();
    targets.accumulation = sum.handle();
    targets.accumulationView = sum.view();
    targets.depth = depth.view();
    targets.depthFormat = depth.format();
    targets.colour = colour.view();
    targets.colourFormat = colour.format();

    const RendererCounters before = g.renderer.counters();
    FrameData frame;
    must(g.renderer.upload(frame, drawing.plan));
    must(headless::submitAndWait(g.device, [&](VkCommandBuffer commands) -> Result<void> {
        // Nothing to draw leaves no group: the sum is then black by definition.
        if (drawing.plan.groups.empty()) return {};
        return g.renderer.recordAccumulation(commands, frame, drawing.plan, 0, std::span(&textures.views, 1), targets);
    }));
    drawing.counters = difference(g.renderer.counters(), before);
    if (drawing.plan.groups.empty()) {
        drawing.sum = {shot.width, shot.height,
                       std::vector<std::array<float, 4>>(static_cast<std::size_t>(shot.width) * shot.height)};
        return drawing;
    }
    drawing.sum = decodePicture(must(headless::readback(g.device, sum, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL)), shot,
                                options.accumulation);
    return drawing;
}

}  // namespace tyndall::test

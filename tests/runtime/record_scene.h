// Targets, lights and pixels for the tests of record(): a lamp in front of the eye, seen at an angle.
#pragma once

#include <headless/commands.h>
#include <headless/image.h>
#include <tyndall/plan.h>
#include <tyndall/renderer.h>

#include <array>
#include <cstring>
#include <vector>

#include "gpu.h"

namespace tyndall::test {

using Rgba = std::array<float, 4>;

/// A picture's texels as floats.
template <class Value>
std::vector<Value> texels(const headless::Image& image, VkImageLayout layout) {
    const std::vector<std::byte> bytes = must(headless::readback(gpu().device, image, layout));
    std::vector<Value> values(bytes.size() / sizeof(Value));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
    return values;
}

template <class Value>
void fill(const headless::Image& image, const std::vector<Value>& values, VkImageLayout layout) {
    must(headless::upload(gpu().device, image, std::as_bytes(std::span(values)), layout));
}

inline headless::Image makeImage(VkExtent2D extent, VkFormat format, VkImageUsageFlags usage, std::string_view name) {
    return must(headless::Image::create(
        gpu().device,
        {extent, format, usage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, name}));
}

/// The targets of a frame: accumulation, depth and a float picture.
struct Stage {
    VkExtent2D extent;
    headless::Image accumulation, depth, colour;

    explicit Stage(VkExtent2D size = {48, 32}, Accumulation format = Accumulation::Rgba32f)
        : extent(size),
          accumulation(makeImage(size, accumulationFormat(format),
                                 VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT, "accumulation")),
          depth(makeImage(size, VK_FORMAT_D32_SFLOAT,
                          VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT, "depth")),
          colour(makeImage(size, VK_FORMAT_R32G32B32A32_SFLOAT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, "colour")) {
        setDepth([](std::uint32_t, std::uint32_t) { return 0.0f; });
        setColour({0.0f, 0.0f, 0.0f, 0.0f});
    }

    template <class Texel>
    void setDepth(Texel&& texel) {
        std::vector<float> values;
        for (std::uint32_t y = 0; y < extent.height; ++y)
            for (std::uint32_t x = 0; x < extent.width; ++x) values.push_back(texel(x, y));
        fill(depth, values, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
    }
    void setColour(Rgba value) {
        fill(colour, std::vector<Rgba>(std::size_t{extent.width} * extent.height, value),
             VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    }
    ShaftTargets targets() const {
        ShaftTargets targets;
        targets.extent = extent;
        targets.accumulation = accumulation.handle();
        targets.accumulationView = accumulation.view();
        targets.depth = depth.view();
        targets.depthFormat = depth.format();
        targets.colour = colour.view();
        targets.colourFormat = colour.format();
        return targets;
    }
    std::vector<Rgba> picture() const { return texels<Rgba>(colour, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL); }
};

/// The textures of one light: a grey-and-white cookie, two noise maps, and a shadow map whose left half is
/// blocked at the lamp.
struct Slides {
    headless::Image cookie, noise, shadowMap;

    Slides() {
        constexpr VkExtent2D size{8, 8};
        cookie = makeImage(size, VK_FORMAT_R32G32B32A32_SFLOAT, VK_IMAGE_USAGE_SAMPLED_BIT, "cookie");
        noise = makeImage(size, VK_FORMAT_R32G32B32A32_SFLOAT, VK_IMAGE_USAGE_SAMPLED_BIT, "noise");
        shadowMap = makeImage(size, VK_FORMAT_D32_SFLOAT,
                              VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, "shadow map");
        std::vector<Rgba> slide, dust;
        std::vector<float> depth;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                const float grey = (x + y) % 2 ? 1.0f : 0.5f;
                slide.push_back({grey, grey, grey, 1.0f});
                dust.push_back(
                    {0.3f + 0.05f * static_cast<float>(x), 0.6f - 0.05f * static_cast<float>(y), 0.0f, 0.0f});
                depth.push_back(x < 4 ? 1.0f : 0.0f);
            }
        fill(cookie, slide, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        fill(noise, dust, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        fill(shadowMap, depth, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    }
    LightTextures views() const { return {cookie.view(), noise.view(), shadowMap.view()}; }
};

/// Is at (-1, 0.5, -3) and looks along +X and slightly away from the eye: lit pixels left and right.
inline Light lamp() {
    const glm::dvec3 z = glm::normalize(glm::dvec3(-1.0, 0.0, 0.2));  // behind the lamp
    const glm::dvec3 y(0.0, 1.0, 0.0);
    Light light;
    light.name = "lamp";
    light.worldFromLight = glm::dmat4(glm::dvec4(glm::cross(y, z), 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0),
                                      glm::dvec4(-1.0, 0.1, -3.0, 1.0));
    light.fov = {0.8, 0.8};
    light.nearPlane = 0.3;
    light.farPlane = 4.0;
    light.intensity = 10.0;
    light.shadow = false;
    return light;
}

inline View eye(const Stage& stage) {
    return perspectiveView(glm::dmat4(1.0), 1.0, static_cast<double>(stage.extent.width) / stage.extent.height, 0.1,
                           100.0);
}

/// Records with `record(commands)` and waits.
template <class Record>
void run(Record&& record) {
    must(headless::submitAndWait(gpu().device, std::function<Result<void>(VkCommandBuffer)>(record)));
}

}  // namespace tyndall::test

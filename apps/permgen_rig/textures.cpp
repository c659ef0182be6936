#include "textures.h"

#include <common/names.h>
#include <common/nearest.h>
#include <fmt/format.h>
#include <kit/fail.h>

#include <algorithm>

namespace tyndall::rig {
namespace {

/// 0 to 1, from a texel's position and channel: T. Wang's integer hash (1997).
float noise(std::uint32_t x, std::uint32_t y, std::uint32_t channel, std::uint32_t seed) {
    std::uint32_t h = x + 4099u * y + 16785407u * channel + 2654435769u * seed;
    h = (h ^ 61u) ^ (h >> 16);
    h *= 9u;
    h ^= h >> 4;
    h *= 0x27d4eb2du;
    h ^= h >> 15;
    return static_cast<float>(h >> 8) / 16777215.0f;
}

float share(const Generated& made, int x, int y, int channel) {
    switch (made.pattern) {
        case Pattern::Constant:
            return 0.0f;
        case Pattern::Checker:
            return static_cast<float>((x * made.cells[0] / made.width + y * made.cells[1] / made.height) % 2);
        case Pattern::Gradient:
            return (static_cast<float>(x) + 0.5f) / static_cast<float>(made.width);
        case Pattern::Noise:
            return noise(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                         static_cast<std::uint32_t>(channel), made.seed);
    }
    return 0.0f;
}

Image generate(const Generated& made) {
    Image image = blankImage(made.width, made.height, 4);
    for (int y = 0; y < made.height; ++y)
        for (int x = 0; x < made.width; ++x)
            for (int c = 0; c < 4; ++c) {
                const float part = share(made, x, y, c);
                image.at(x, y, c) = made.colours[0][c] + part * (made.colours[1][c] - made.colours[0][c]);
            }
    return image;
}

/// Grey is copied to three channels; images without alpha are opaque.
Image fourChannels(const Image& image) {
    Image wide = blankImage(image.width, image.height, 4);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            for (int c = 0; c < 3; ++c) wide.at(x, y, c) = image.at(x, y, image.channels < 3 ? 0 : c);
            const bool alpha = image.channels == 2 || image.channels == 4;
            wide.at(x, y, 3) = alpha ? image.at(x, y, image.channels - 1) : 1.0f;
        }
    return wide;
}

Result<Image> load(const TextureSource& source) {
    if (const auto* made = std::get_if<Generated>(&source)) return generate(*made);
    auto image = readImage(std::get<ImageFile>(source).path);
    if (!image) return image;
    return fourChannels(*image);
}

/// The first technique that reads the resource; empty if there is none.
std::string_view readerOf(const permgen::Effect& effect, std::string_view resource) {
    for (const permgen::Technique& technique : effect.techniques)
        for (const permgen::Pass& pass : technique.passes)
            if (permgen::is_live(pass, resource)) return technique.name;
    return {};
}

}  // namespace

Result<Texels> makeTextures(const permgen::Effect& effect, const Fixture& fixture) {
    const auto fail = [&](const std::string& name, const std::string& why) {
        return failWith(fmt::format("{}: textures.{}: {}", fixture.path, name, why));
    };
    std::vector<std::string_view> samplers;
    for (const permgen::Resource& resource : effect.resources)
        if (resource.kind == permgen::ResourceKind::CombinedImageSampler) samplers.push_back(resource.name);
    for (const auto& [name, source] : fixture.textures)
        if (std::find(samplers.begin(), samplers.end(), name) == samplers.end())
            return fail(name, fmt::format("{} has no such sampler{}", effect.name,
                                          permgen::suggestion(name, samplers, "; did you mean ", "?")));

    Texels texels;
    for (const permgen::Resource& resource : effect.resources) {
        if (resource.kind != permgen::ResourceKind::CombinedImageSampler) continue;
        const std::string name(resource.name);
        const std::string_view reader = readerOf(effect, resource.name);
        const auto source = fixture.textures.find(name);
        if (resource.dimension != permgen::ImageDimension::Two) {
            if (reader.empty()) continue;
            return fail(name,
                        fmt::format("{} reads it, but it is a {}, which a fixture cannot fill; leave the technique "
                                    "out with --technique",
                                    reader, permgen::resource_name(resource.kind, resource.dimension)));
        }
        if (source == fixture.textures.end()) {
            if (reader.empty()) continue;
            return fail(name, fmt::format("{} reads it, but the fixture gives it no texture; give it one, such as "
                                          "{{\"generate\": \"checker\"}}",
                                          reader));
        }
        auto image = load(source->second);
        if (!image) return fail(name, image.error().message);
        if (const std::string why = whyNotFinite(*image); !why.empty()) return fail(name, why);
        texels.emplace(name, std::move(*image));
    }
    return texels;
}

Image altered(const Image& texels) {
    Image other = texels;
    for (std::size_t i = 0; i < other.values.size(); ++i) {
        const float value = other.values[i];
        // Mirrored within 0 to 1, and moved, so that 0.5 changes too.
        other.values[i] =
            (value < 0.5f ? 0.9f : 0.05f) + 0.0625f * static_cast<float>(i % 4) * (value < 0.5f ? -1.0f : 1.0f);
    }
    return other;
}

}  // namespace tyndall::rig

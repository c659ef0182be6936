#include "slice_constants.h"

#include <tyndall/air.h>
#include <tyndall/article.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "shape/slide.h"

namespace tyndall {
namespace {

constexpr glm::vec4 keepEverything{0.0f, 0.0f, 0.0f, 1.0f};

// Phase of a scrolling texture in [0, 1), taken in double: float seconds advance in steps of 3.9 ms after ten hours,
// and the dust would visibly jump.
float phase(double turns) {
    const auto part = static_cast<float>(turns - std::floor(turns));
    return part >= 1.0f ? 0.0f : part;  // a part of 1 - 1e-9 rounds up to a whole turn
}

glm::vec4 noiseMap(const glm::dvec2& scale, const glm::dvec2& scroll, double time) {
    return {glm::vec2(scale), phase(scroll.x * time), phase(scroll.y * time)};
}

glm::vec4 shadowConstants(const Light& light, const PlanOptions& options, double bias) {
    const ShadowDepth depth = shadowDepth(light);
    return glm::dvec4(depth.constant, depth.overAxis, options.shadowMapSize, std::min(bias, 0.99 * light.nearPlane));
}

glm::vec4 dustConstants(const Light& light, const PlanOptions& options, TermSet terms, double factor) {
    const bool physical = options.look == Look::Physical;
    const double flat = physical ? factor : article::flatDust;
    // A light without noise that is drawn with a noise technique reads a white texture: this gain makes it look as
    // without noise.
    if (terms.contains(Term::Noise) && !light.noise) return glm::dvec4(flat, flat, 0.0, 0.0);
    const double gain = physical ? light.noise.value_or(Noise{}).gain : article::noiseGain;
    return glm::dvec4(flat, gain, 0.0, 0.0);
}

glm::vec4 colourConstants(const Light& light, const PlanOptions& options, const StandIns& standIns) {
    glm::dvec3 factor(1.0);
    for (const Term term : allTerms)
        if (term != Term::Noise) factor *= standIns[term];  // gDust holds the noise's factor
    const double scattered = options.look == Look::Physical ? light.density / (4.0 * glm::pi<double>()) : 1.0;
    const bool routed = options.accumulation == Accumulation::Rgba8Routed;
    const glm::dvec3 colour = routed ? glm::dvec3(greyOf(light)) : light.colour;
    return glm::dvec4(colour * factor * scattered * targetScale(options), routed ? 1.0 : 0.0);
}

glm::vec4 weightConstants(const View& view, const PlanOptions& options) {
    if (options.look == Look::Article) return glm::dvec4(article::weight / options.slices, 0.0, 0.0, 0.0);
    return glm::dvec4(1.0, 1.0, view.orthographic ? 0.0 : 1.0, 0.0);
}

// The published picture scatters evenly in clear air.
glm::vec4 scatteringConstants(const Light& light, const View& view, const PlanOptions& options) {
    const bool physical = options.look == Look::Physical;
    const double g = physical ? light.anisotropy : 0.0;
    return glm::dvec4(g, physical ? extinction(light) : 0.0, 1.0 - std::abs(g), view.orthographic ? 1.0 : 0.0);
}

glm::vec4 eyeConstants(const View& view, const LightPose& pose) {
    if (!view.orthographic) return glm::dvec4(glm::dvec3(pose.lightFromView[3]), 0.0);
    return glm::dvec4(glm::normalize(glm::dvec3(pose.lightFromView[2])), -pose.viewFromLight[3].z);
}

// The bounds must hold the volume after rounding to float. A small margin costs nothing, because the clip planes cut
// off the rest. Depth gets no margin: both geometries have their slices at the same depths.
void stretchOver(SliceConstants& constants, const LightVolume& volume, const Slabs& slabs) {
    const glm::dvec2 margin = 1e-6 * (glm::abs(volume.boundsMin) + glm::abs(volume.boundsMax)) + 1e-9;
    constants.boundsMin = glm::dvec4(volume.boundsMin - margin, -slabs.farDepth, 0.0);
    constants.boundsMax = glm::dvec4(volume.boundsMax + margin, -slabs.nearDepth, 0.0);
    const VolumePlanes planes = boundingPlanes(volume);
    for (std::size_t i = 0; i < planes.size() && i < std::size(constants.clipPlanes); ++i)
        constants.clipPlanes[i] = planes[i];
}

}  // namespace

double greyOf(const Light& light) {
    return std::max({light.colour.r, light.colour.g, light.colour.b});
}

double targetScale(const PlanOptions& options) {
    const bool eightBits =
        options.accumulation == Accumulation::Rgba8 || options.accumulation == Accumulation::Rgba8Routed;
    return eightBits ? 1.0 / options.range : 1.0;
}

SliceConstants sliceConstants(const Light& light, const View& view, const PlanOptions& options, const LightPose& pose,
                              const LightVolume& volume, const Slabs& slabs, TermSet terms, double shadowBias,
                              const StandIns& standIns) {
    SliceConstants constants{};
    constants.clipFromView = view.clipFromView;
    constants.lightFromView = pose.lightFromView;
    constants.boundsMax = {1.0f, 1.0f, 1.0f, 0.0f};
    std::fill(std::begin(constants.clipPlanes), std::end(constants.clipPlanes), keepEverything);
    if (options.geometry == Geometry::StretchedQuads) stretchOver(constants, volume, slabs);

    constants.cookieScale = glm::dvec4(cookieScale(shapeOf(light)), 0.0, 0.0);
    constants.attenuation = options.look == Look::Physical
                                ? glm::dvec4(light.intensity, light.ambient, 1.0, 0.0)
                                : glm::dvec4(article::intensity, article::ambient, article::inchesPerMetre, 0.0);
    constants.dust = dustConstants(light, options, terms, standIns[Term::Noise].x);
    const Noise noise = light.noise.value_or(Noise{});
    constants.noise1 = noiseMap(noise.scale, noise.scroll1, options.time);
    constants.noise2 = noiseMap(noise.scale, noise.scroll2, options.time);
    constants.colour = colourConstants(light, options, standIns);
    constants.weight = weightConstants(view, options);
    constants.shadow = shadowConstants(light, options, shadowBias);
    constants.scattering = scatteringConstants(light, view, options);
    constants.eye = eyeConstants(view, pose);
    return constants;
}

bool isFinite(const SliceConstants& constants) {
    const auto numbers = std::bit_cast<std::array<float, sizeof(SliceConstants) / sizeof(float)>>(constants);
    return std::all_of(numbers.begin(), numbers.end(), [](float number) { return std::isfinite(number); });
}

}  // namespace tyndall

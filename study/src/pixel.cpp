#include "pixel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "light_integral.h"
#include "occlusion.h"
#include "scattering.h"

namespace tyndall::study {
namespace {

// Relative rounding error: a few ulp for each of some dozen sums, roots and divisions of doubles. No subtraction
// cancels and all terms are positive or 0, so the error stays relative.
constexpr double rounding = 64.0 * 0x1p-53;

// Maximum error of a shadow's edge in metres.
double edgeErrorOf(Mode mode, const Light& light, const LightRay& ray, Span span) {
    if (mode == Mode::Ideal) return edgeError(ray, span);
    // The axis distance meets a texel's where the ray may run almost along it.
    const double farthest = std::max(std::abs(span.begin), std::abs(span.end));
    return std::min(0x1p-52 * (farthest + light.farPlane / std::abs(ray.direction.z)), span.end - span.begin);
}

// The same as light: each edge of a lit stretch, except the ends of the span, may add or remove this much.
double edgeLight(Mode mode, const Light& light, const LightRay& ray, Span span, const std::vector<LitSpan>& lit) {
    const Scattering scattering(light, ray);
    const double gain = light.noise ? light.noise->gain : 1.0;
    const auto brightness = [&](double s) {
        return gain * (light.intensity / (ray.distance * ray.distance + s * s) + light.ambient) *
               (scattering.none() ? 1.0 : scattering.at(s));
    };
    double sum = 0.0;
    for (const LitSpan& stretch : lit) {
        if (stretch.span.begin > span.begin) sum += brightness(stretch.span.begin);
        if (stretch.span.end < span.end) sum += brightness(stretch.span.end);
    }
    return sum * edgeErrorOf(mode, light, ray, span);
}

}  // namespace

PreparedScene prepare(const ReferenceScene& scene) {
    const bool ideal = scene.mode == Mode::Ideal;
    PreparedScene prepared{scene, Surfaces(scene.view, ideal ? scene.triangles : std::vector<Triangle>{}), {}, {}};
    for (const ReferenceLight& light : scene.lights) {
        const bool shadow = light.light.shadow;
        prepared.occluders.push_back(ideal && shadow ? occluders(light.light, scene.triangles) : TriangleTree());
        // The bias is limited so that points stay before the lamp; plan() does the same.
        const double bias = std::min(scene.shadowBias, 0.99 * light.light.nearPlane);
        prepared.shadowMaps.push_back(!ideal && shadow ? shadowMap(light.light, light.shadowMap, bias) : ShadowMap());
    }
    return prepared;
}

Span visible(const PreparedScene& prepared, const ViewRay& ray, int x, int y) {
    const ReferenceScene& scene = prepared.scene;
    Span span{scene.view.nearPlane * ray.perDepth, scene.view.farPlane * ray.perDepth};
    if (scene.mode == Mode::Ideal)
        span.end = std::min(span.end, prepared.surfaces.firstHit(ray, span.begin, span.end));
    else if (!scene.depth.values.empty())
        span.end =
            std::min(span.end, depthOf(scene.view, ray, static_cast<double>(scene.depth.at(x, y, 0))) * ray.perDepth);
    return span;
}

Pixel integratePixel(const PreparedScene& prepared, int x, int y, double accuracy) {
    const ReferenceScene& scene = prepared.scene;
    const ViewRay view = viewRay(scene.view, scene.width, scene.height, x + 0.5, y + 0.5);
    const Span seen = visible(prepared, view, x, y);
    Pixel pixel;
    std::vector<LitSpan> lit;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const ReferenceLight& light = scene.lights[i];
        const glm::dvec3 scatter = light.light.colour * (light.light.density / (4.0 * std::numbers::pi));
        if (scatter == glm::dvec3(0.0)) continue;
        const LightRay ray = lightRay(light.light, scene.view, view);
        const Span span = clipToLight(light.light, ray, {seen.begin - ray.footLength, seen.end - ray.footLength});
        if (span.empty()) continue;
        const TexelPath shadow = texelPath(prepared.shadowMaps[i].stored, project(light.light, ray));
        lit.clear();
        if (!light.light.shadow)
            lit.push_back({span});
        else if (scene.mode == Mode::Ideal)
            litSpans(lit, prepared.occluders[i], light.light.nearPlane, ray, span);
        else
            litSpans(lit, prepared.shadowMaps[i], shadow, ray, span);
        const Quadrature integral = lightIntegral(light, ray, texturePaths(light, ray, scene.time), shadow,
                                                  prepared.shadowMaps[i], lit, accuracy);
        pixel.radiance += scatter * integral.value;
        const double edges = light.light.shadow ? edgeLight(scene.mode, light.light, ray, span, lit) : 0.0;
        const double rounded = rounding * (1.0 + Scattering(light.light, ray).conditioning(span));
        pixel.error += scatter * (integral.error + rounded * integral.value + edges);
        pixel.evaluations += integral.evaluations;
    }
    return pixel;
}

}  // namespace tyndall::study

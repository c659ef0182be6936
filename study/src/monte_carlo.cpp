#include <fmt/format.h>
#include <study/monte_carlo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "check_scene.h"
#include "light_ray.h"
#include "surfaces.h"

namespace tyndall::study {
namespace {

// Separate estimates, whose spread gives the error. The spread within strata cannot give it: one stratum with a
// shadow's edge outweighs thousands of smooth ones.
constexpr int replicates = 32;

double unit(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

double texel(const Image& texture, double i, double j, int channel, bool wrap) {
    const auto place = [wrap](double k, int size) {
        if (wrap) return static_cast<int>(k - size * std::floor(k / size));
        return static_cast<int>(std::clamp(k, 0.0, size - 1.0));
    };
    return static_cast<double>(texture.at(place(i, texture.width), place(j, texture.height), channel));
}

// Any function of the four texels around u, v, weighted bilinearly.
template <class F>
double bilinear(const Image& texture, double u, double v, const F& value) {
    const double x = u * texture.width - 0.5, y = v * texture.height - 0.5;
    const double i = std::floor(x), j = std::floor(y), fx = x - i, fy = y - j;
    return (value(i, j) * (1.0 - fx) + value(i + 1.0, j) * fx) * (1.0 - fy) +
           (value(i, j + 1.0) * (1.0 - fx) + value(i + 1.0, j + 1.0) * fx) * fy;
}

double sample(const Image& texture, double u, double v, int channel, bool wrap) {
    return bilinear(texture, u, v, [&](double i, double j) { return texel(texture, i, j, channel, wrap); });
}

double falloff(const Cone& cone, double angle) {
    if (angle >= cone.outer) return 0.0;
    const double scale = 1.0 / std::max(0.001, std::cos(cone.inner) - std::cos(cone.outer));
    const double share = std::min(1.0, scale * (std::cos(angle) - std::cos(cone.outer)));
    return share * share;
}

struct PointTest {
    const ReferenceScene& scene;
    const ReferenceLight& light;
    const Surfaces& surfaces;
    glm::dmat4 lightFromView;

    // The shaders' own comparison, in stored depth.
    double mapped(double u, double v, double axis) const {
        const double n = light.light.nearPlane, f = light.light.farPlane;
        const double a = axis - std::min(scene.shadowBias, 0.99 * n);
        const double depth = std::clamp(n * (f - a) / (a * (f - n)), 0.0, 1.0 - 0x1p-24);
        return bilinear(light.shadowMap, u, v, [&](double i, double j) {
            return depth >= texel(light.shadowMap, i, j, 0, false) ? 1.0 : 0.0;
        });
    }

    double shadow(const glm::dvec3& view, const glm::dvec3& p, double u, double v) const {
        if (!light.light.shadow) return 1.0;
        if (scene.mode == Mode::Hardware) return mapped(u, v, -p.z);
        // Starts at the near plane: triangles before it throw no shadow.
        const glm::dvec3 start = p * (light.light.nearPlane / -p.z);
        return surfaces.blocked(glm::dvec3(glm::inverse(lightFromView) * glm::dvec4(start, 1.0)), view) ? 0.0 : 1.0;
    }

    // Henyey and Greenstein's phase function times 4 pi, and the air's transmittance along both paths. The eye is at
    // the view's origin, or infinitely far behind the plane of depth 0.
    double scattered(const glm::dvec3& view) const {
        const Light& l = light.light;
        const glm::dvec3 fromLamp = view - glm::dvec3(glm::inverse(lightFromView)[3]);
        const glm::dvec3 toEye = scene.view.orthographic ? glm::dvec3(0.0, 0.0, 1.0) : glm::normalize(-view);
        const double cosine = glm::dot(glm::normalize(fromLamp), toEye);
        const double g = l.anisotropy;
        const double phase = (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
        if (!l.albedo) return phase;
        const double back = scene.view.orthographic ? -view.z : glm::length(view);
        return phase * std::exp(-l.density / *l.albedo * (glm::length(fromLamp) + back));
    }

    // The integrand at a point of view space.
    glm::dvec3 at(const glm::dvec3& view) const {
        const Light& l = light.light;
        const glm::dvec3 p(lightFromView * glm::dvec4(view, 1.0));
        const double axis = -p.z;
        if (axis < l.nearPlane || axis > l.farPlane) return glm::dvec3(0.0);
        const double u = 0.5 + 0.5 * p.x / (axis * std::tan(0.5 * l.fov.x));
        const double v = 0.5 - 0.5 * p.y / (axis * std::tan(0.5 * l.fov.y));
        if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0) return glm::dvec3(0.0);
        const glm::dvec3 world(scene.view.worldFromView * glm::dvec4(view, 1.0));
        for (const glm::dvec4& plane : l.clipPlanes)
            if (glm::dot(glm::dvec3(plane), world) + plane.w < 0.0) return glm::dvec3(0.0);

        double mask = shadow(view, p, u, v);
        if (mask == 0.0) return glm::dvec3(0.0);
        if (l.noise) {
            const auto red = l.noise->scale * glm::dvec2(u, v) + l.noise->scroll1 * scene.time;
            const auto green = l.noise->scale * glm::dvec2(u, v) + l.noise->scroll2 * scene.time;
            mask *= l.noise->gain * sample(light.noise, red.x, red.y, 0, true) *
                    sample(light.noise, green.x, green.y, 1, true);
        }
        if (light.cone) mask *= falloff(*light.cone, std::acos(axis / glm::length(p)));
        glm::dvec3 colour = l.colour * (l.density / (4.0 * std::numbers::pi));
        if (l.cookie)
            for (int c = 0; c < 3; ++c) colour[c] *= sample(light.cookie, u, v, c, false);
        return colour * (mask * scattered(view) * (l.intensity / glm::dot(p, p) + l.ambient));
    }
};

}  // namespace

Result<Estimate> monteCarlo(const ReferenceScene& scene, int x, int y, int samples, std::uint64_t seed) {
    if (auto checked = checkScene(scene, {}); !checked) return tl::unexpected(checked.error());
    if (samples < replicates)
        return tl::unexpected(Error{ErrorCode::InvalidArgument,
                                    fmt::format("an estimate takes at least {} samples; give more", replicates)});
    const bool ideal = scene.mode == Mode::Ideal;
    const Surfaces surfaces(scene.view, ideal ? scene.triangles : std::vector<Triangle>{});
    const ViewRay ray = viewRay(scene.view, scene.width, scene.height, x + 0.5, y + 0.5);
    const double begin = scene.view.nearPlane * ray.perDepth;
    double end = scene.view.farPlane * ray.perDepth;
    if (ideal)
        end = std::min(end, surfaces.firstHit(ray, begin, end));
    else if (!scene.depth.values.empty())
        end = std::min(end, depthOf(scene.view, ray, static_cast<double>(scene.depth.at(x, y, 0))) * ray.perDepth);

    std::mt19937_64 random(seed);
    const int strata = samples / replicates;
    std::array<glm::dvec3, replicates> sums{};
    for (const ReferenceLight& light : scene.lights) {
        const glm::dmat4 lightFromView = glm::inverse(light.light.worldFromLight) * scene.view.worldFromView;
        const PointTest test{scene, light, surfaces, lightFromView};
        const glm::dvec3 lamp(glm::inverse(lightFromView)[3]);
        const double foot = glm::dot(lamp - ray.origin, ray.direction);
        const double h = glm::length(lamp - ray.origin - foot * ray.direction);
        // The far corners are the points of the light's volume farthest from the lamp.
        const glm::dvec2 slope = glm::tan(0.5 * light.light.fov);
        const double farthest = light.light.farPlane * std::sqrt(1.0 + glm::dot(slope, slope));
        const double from = std::atan2(std::max(begin - foot, -farthest), h);
        const double to = std::atan2(std::min(end - foot, farthest), h);
        if (!(from < to)) continue;
        const double width = (to - from) / strata;
        for (glm::dvec3& sum : sums) {
            // The strata start at random positions: an edge at a fixed position within a stratum would be hit by few
            // replicates or by none, and their spread would not show it.
            const double shift = unit(random);
            for (int i = 0; i < strata; ++i) {
                const double place = std::fmod(i + shift + unit(random), strata);
                const double s = h * std::tan(from + place * width);
                // Density of s: h / ((to - from) (h^2 + s^2)).
                sum += test.at(ray.origin + (foot + s) * ray.direction) * ((h * h + s * s) / h * width);
            }
        }
    }
    Estimate estimate;
    for (const glm::dvec3& sum : sums) estimate.mean += sum / static_cast<double>(replicates);
    glm::dvec3 squares(0.0);
    for (const glm::dvec3& sum : sums) squares += (sum - estimate.mean) * (sum - estimate.mean);
    estimate.standardError = glm::sqrt(squares / (replicates * (replicates - 1.0)));
    return estimate;
}

}  // namespace tyndall::study

#include "automatic_range.h"

#include <tyndall/article.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tyndall::app {
namespace {

constexpr int columns = 32, rows = 18, steps = 256;
constexpr double smallest = 1e-9;

/// Metres from the eye to the farthest air that any light fills and the view can show.
double farthestLit(std::span<const Light> lights, const View& view) {
    double farthest = view.nearPlane * 2.0;
    for (const Light& light : lights) {
        const double lamp = glm::length(glm::dvec3(light.worldFromLight[3] - view.worldFromView[3]));
        farthest = std::max(farthest, lamp + maxDistance(light));
    }
    return std::min({farthest, view.farPlane, std::max(view.sceneDepth, view.nearPlane * 2.0)});
}

double scattered(const Light& light, const glm::dmat4& lightFromWorld, const glm::dvec3& world, Look look) {
    const glm::dvec3 p(lightFromWorld * glm::dvec4(world, 1.0));
    const double axis = -p.z;
    if (axis < light.nearPlane || axis > light.farPlane) return 0.0;
    const glm::dvec2 half = axis * tanHalfFov(light);
    if (std::abs(p.x) > half.x || std::abs(p.y) > half.y) return 0.0;
    for (const glm::dvec4& plane : light.clipPlanes)
        if (glm::dot(plane, glm::dvec4(world, 1.0)) < 0.0) return 0.0;
    const double brightest = std::max({light.colour.r, light.colour.g, light.colour.b});
    if (look == Look::Article) {
        const glm::dvec3 inches = article::inchesPerMetre * p;
        return brightest * (article::ambient + article::intensity / glm::dot(inches, inches));
    }
    return brightest * light.density / (4.0 * std::numbers::pi) * (light.intensity / glm::dot(p, p) + light.ambient);
}

}  // namespace

double automaticRange(std::span<const Light> lights, const View& view, Look look) {
    std::vector<glm::dmat4> lightFromWorld;
    for (const Light& light : lights) lightFromWorld.push_back(glm::inverse(light.worldFromLight));
    const double farthest = farthestLit(lights, view);
    const glm::dmat4 viewFromClip = glm::inverse(view.clipFromView);
    // The article adds a constant for each of its slices, whatever its thickness.
    const double perStep =
        look == Look::Article ? article::weight * article::flatDust / steps : (farthest - view.nearPlane) / steps;
    double brightest = smallest;
    for (int pixel = 0; pixel < columns * rows; ++pixel) {
        const double x = 2.0 * (pixel % columns + 0.5) / columns - 1.0;
        const double y = 2.0 * (pixel / columns + 0.5) / rows - 1.0;
        const glm::dvec4 onNear = viewFromClip * glm::dvec4(x, y, 1.0, 1.0);  // reversed depth: 1 is near
        const glm::dvec3 start(onNear / onNear.w);
        const glm::dvec3 direction = view.orthographic ? glm::dvec3(0.0, 0.0, -1.0) : start / -start.z;
        const glm::dvec3 origin = view.orthographic ? glm::dvec3(start.x, start.y, 0.0) : glm::dvec3(0.0);
        double sum = 0.0;
        for (int step = 0; step < steps; ++step) {
            const double depth = view.nearPlane + (farthest - view.nearPlane) * (step + 0.5) / steps;
            const glm::dvec3 world(view.worldFromView * glm::dvec4(origin + depth * direction, 1.0));
            for (std::size_t i = 0; i < lights.size(); ++i) sum += scattered(lights[i], lightFromWorld[i], world, look);
        }
        brightest = std::max(brightest, sum * perStep * (look == Look::Article ? 1.0 : glm::length(direction)));
    }
    return brightest;
}

}  // namespace tyndall::app

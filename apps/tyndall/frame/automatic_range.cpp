#include "automatic_range.h"

#include <tyndall/air.h>
#include <tyndall/article.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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

/// A step of the view ray through the middle of a cell of the grid.
struct Step {
    glm::dvec3 middle, toEye;  ///< world space; the latter of unit length
    double nearEye, farEye;    ///< metres along the ray from the eye, or the plane of depth 0, to the step's ends
    double angle, width;       ///< from the ray to the cell's corners, in radians and in metres at the step
};

/// phase * transmittance, of the cell's rays that with the largest phase function and the shortest way.
double shareOfAir(const Light& light, const Step& step) {
    const glm::dvec3 lamp(light.worldFromLight[3]), fromLamp = step.middle - lamp;
    const double distance = glm::length(fromLamp);
    double share = 1.0;
    if (light.anisotropy != 0.0) {
        const double turn = std::acos(std::clamp(glm::dot(fromLamp, step.toEye) / distance, -1.0, 1.0));
        const double other = step.angle + std::asin(std::min(step.width / distance, 1.0));
        share = phase(light.anisotropy, light.anisotropy < 0.0 ? std::min(turn + other, std::numbers::pi)
                                                               : std::max(turn - other, 0.0));
    }
    if (const double loss = extinction(light); loss > 0.0) {
        // A step may be longer than light gets: the mean over the step. The way only grows along a ray.
        const glm::dvec3 half = 0.5 * (step.farEye - step.nearEye) * step.toEye;
        const double shortest = glm::length(fromLamp + half) + step.nearEye - step.width;
        const double longest = glm::length(fromLamp - half) + step.farEye - step.width;
        const double fall = loss * (longest - shortest);
        share *= std::exp(-loss * std::max(shortest, 0.0)) * (fall > 1e-6 ? -std::expm1(-fall) / fall : 1.0);
    }
    return share;
}

/// Of what the light is drawn with.
bool scatters(const Light& light, const ShaftOptions& options) {
    return options.look == Look::Physical && (light.anisotropy != 0.0 || light.albedo) &&
           (!options.terms || options.terms->contains(Term::Scattering));
}

}  // namespace

double automaticRange(std::span<const Light> lights, const View& view, const ShaftOptions& options) {
    std::vector<glm::dmat4> lightFromWorld;
    for (const Light& light : lights) lightFromWorld.push_back(glm::inverse(light.worldFromLight));
    const double farthest = farthestLit(lights, view);
    const glm::dmat4 viewFromClip = glm::inverse(view.clipFromView);
    // The article adds a constant for each of its slices, whatever its thickness.
    const double perStep =
        options.look == Look::Article ? article::weight * article::flatDust / steps : (farthest - view.nearPlane) / steps;
    double brightest = smallest;
    const auto rayAt = [&](double x, double y) {  // start on the near plane and direction for a metre of depth
        const glm::dvec4 onNear = viewFromClip * glm::dvec4(x, y, 1.0, 1.0);  // reversed depth: 1 is near
        const glm::dvec3 start(onNear / onNear.w);
        return std::pair(start, view.orthographic ? glm::dvec3(0.0, 0.0, -1.0) : start / -start.z);
    };
    for (int pixel = 0; pixel < columns * rows; ++pixel) {
        const double x = 2.0 * (pixel % columns + 0.5) / columns - 1.0;
        const double y = 2.0 * (pixel / columns + 0.5) / rows - 1.0;
        const auto [start, direction] = rayAt(x, y);
        const glm::dvec3 origin = view.orthographic ? glm::dvec3(start.x, start.y, 0.0) : glm::dvec3(0.0);
        const double slant = glm::length(direction);
        // Cells grow towards the picture's middle, where the corner towards it is the farther one.
        const auto [corner, cornerDirection] = rayAt(x - std::copysign(1.0 / columns, x), y - std::copysign(1.0 / rows, y));
        const double angle = std::atan2(glm::length(glm::cross(direction, cornerDirection)), glm::dot(direction, cornerDirection));
        const double width = view.orthographic ? glm::distance(start, corner) : 0.0;
        const glm::dvec3 toEye(view.worldFromView * glm::dvec4(-direction / slant, 0.0));
        double sum = 0.0;
        for (int step = 0; step < steps; ++step) {
            const double depth = view.nearPlane + (farthest - view.nearPlane) * (step + 0.5) / steps;
            const glm::dvec3 world(view.worldFromView * glm::dvec4(origin + depth * direction, 1.0));
            const double half = 0.5 * (farthest - view.nearPlane) / steps;
            const Step here{world, toEye, slant * (depth - half), slant * (depth + half), angle, width + slant * depth * angle};
            for (std::size_t i = 0; i < lights.size(); ++i) {
                const double even = scattered(lights[i], lightFromWorld[i], world, options.look);
                sum += even > 0.0 && scatters(lights[i], options) ? even * shareOfAir(lights[i], here) : even;
            }
        }
        brightest = std::max(brightest, sum * perStep * (options.look == Look::Article ? 1.0 : slant));
    }
    return brightest;
}

}  // namespace tyndall::app

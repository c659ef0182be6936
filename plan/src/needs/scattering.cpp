#include "needs/scattering.h"

#include <tyndall/air.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <span>

namespace tyndall {
namespace {

struct Cone {
    glm::dvec3 axis{0.0, 0.0, 1.0};
    double halfAngle = glm::pi<double>();  // of a cone of all directions
};

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Holds all directions between these. A cone is convex only if it is narrower than a half space.
Cone coneAround(std::span<const glm::dvec3> directions) {
    constexpr double rounding = 1e-7;
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& direction : directions) {
        const double length = glm::length(direction);
        if (!(length > 0.0)) return {};
        sum += direction / length;
    }
    if (!(glm::length(sum) > 0.0)) return {};
    Cone cone{glm::normalize(sum), 0.0};
    for (const glm::dvec3& direction : directions)
        cone.halfAngle = std::max(cone.halfAngle, angleBetween(cone.axis, direction) + rounding);
    return cone.halfAngle < 0.49 * glm::pi<double>() ? cone : Cone{};
}

}  // namespace

bool scatters(const Light& light) {
    return light.anisotropy != 0.0 || light.albedo.has_value();
}

FactorRange scatteringRange(const Light& light, const View& view, const LightPose& pose, const SeenAir& air) {
    if (!scatters(light)) return {};
    const glm::dvec3 eye(pose.lightFromView[3]), lamp(pose.viewFromLight[3]);
    std::array<glm::dvec3, 8> corners, toEye;
    double nearest = air.axisNear, farthest = 0.0, longest = 0.0;
    for (std::size_t i = 0; i < 8; ++i) {
        const glm::dvec2 slope((i & 1) ? air.slopes.max.x : air.slopes.min.x,
                               (i & 2) ? air.slopes.max.y : air.slopes.min.y);
        corners[i] = glm::dvec3(slope, -1.0) * ((i & 4) ? air.axisFar : air.axisNear);
        toEye[i] = view.orthographic ? glm::dvec3(pose.lightFromView[2]) : eye - corners[i];
        farthest = std::max(farthest, glm::length(corners[i]));
        longest = std::max(longest, glm::length(toEye[i]));
    }
    // The straight line is the shortest path from lamp to eye. Parallel rays end at depth 0.
    const double minPath = view.orthographic ? std::max(nearest + air.nearDepth, -lamp.z)
                                             : std::max(nearest + air.nearDepth, glm::length(eye));
    const double maxPath = farthest + (view.orthographic ? air.farDepth : longest);

    const Cone fromLamp = coneAround(corners), back = coneAround(toEye);
    const double between = angleBetween(fromLamp.axis, back.axis), spread = fromLamp.halfAngle + back.halfAngle;
    const double sharpest = std::max(between - spread, 0.0), widest = std::min(between + spread, glm::pi<double>());
    const auto [low, high] = std::minmax({phase(light.anisotropy, sharpest), phase(light.anisotropy, widest)});
    return {glm::dvec3(low * std::exp(-extinction(light) * maxPath)),
            glm::dvec3(high * std::exp(-extinction(light) * minPath))};
}

double phasePeak(const Light& light) {
    return std::max(1.0, phase(light.anisotropy, light.anisotropy < 0.0 ? glm::pi<double>() : 0.0));
}

}  // namespace tyndall

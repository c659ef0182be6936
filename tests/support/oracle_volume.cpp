#include "oracle_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tyndall::test {
namespace {

HalfSpace through(glm::dvec3 point, glm::dvec3 inward) {
    const glm::dvec3 n = glm::normalize(inward);
    return {n, -glm::dot(n, point)};
}

}  // namespace

std::vector<HalfSpace> lightVolume(const Light& light, const glm::dmat4& spaceFromWorld) {
    // World positions may be large: subtract them before the product with a normal.
    const glm::dmat4 frame = spaceFromWorld * light.worldFromLight;
    const glm::dvec3 right(frame[0]), up(frame[1]), back(frame[2]), lamp(frame[3]);
    const glm::dvec3 ahead = -back;
    const double h = 0.5 * light.fov.x, v = 0.5 * light.fov.y;

    std::vector<HalfSpace> volume{
        through(lamp + ahead * light.nearPlane, ahead),
        through(lamp + ahead * light.farPlane, back),
        through(lamp, ahead * std::sin(h) + right * std::cos(h)),
        through(lamp, ahead * std::sin(h) - right * std::cos(h)),
        through(lamp, ahead * std::sin(v) + up * std::cos(v)),
        through(lamp, ahead * std::sin(v) - up * std::cos(v)),
    };
    const glm::dmat4 worldFromSpace = glm::inverse(spaceFromWorld);
    const glm::dvec3 origin(worldFromSpace[3]);
    for (const glm::dvec4& plane : light.clipPlanes) {
        const double length = glm::length(glm::dvec3(plane));
        const glm::dvec3 n = glm::dvec3(plane) / length;
        volume.push_back({glm::dmat3(spaceFromWorld) * n, glm::dot(n, origin) + plane.w / length});
    }
    return volume;
}

std::vector<glm::dvec3> corners(const std::vector<HalfSpace>& volume) {
    std::vector<glm::dvec3> found;
    const std::size_t n = volume.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j)
            for (std::size_t k = j + 1; k < n; ++k) {
                const glm::dvec3 a = volume[i].normal, b = volume[j].normal, c = volume[k].normal;
                const double det = glm::dot(a, glm::cross(b, c));
                if (std::abs(det) < 1e-12) continue;  // two are parallel, or all share a direction
                const glm::dvec3 p = -(volume[i].offset * glm::cross(b, c) + volume[j].offset * glm::cross(c, a) +
                                       volume[k].offset * glm::cross(a, b)) /
                                     det;
                const bool kept = std::all_of(volume.begin(), volume.end(), [&](const HalfSpace& plane) {
                    return plane.distance(p) >= -1e-9 * (1.0 + glm::length(p));
                });
                if (kept) found.push_back(p);
            }
    return found;
}

Range depthRange(const std::vector<glm::dvec3>& corners, double nearPlane, double farPlane) {
    Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const glm::dvec3& p : corners) {
        range.nearest = std::min(range.nearest, -p.z);
        range.farthest = std::max(range.farthest, -p.z);
    }
    return {std::max(range.nearest, nearPlane), std::min(range.farthest, farPlane)};
}

}  // namespace tyndall::test

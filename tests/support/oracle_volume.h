// The oracle's light volume: half spaces, with geometry by brute force.
#pragma once

#include <tyndall/light.h>

#include <glm/glm.hpp>
#include <vector>

namespace tyndall::test {

/// Keeps dot(normal, p) + offset >= 0; `normal` has unit length, so that is a distance in metres.
struct HalfSpace {
    glm::dvec3 normal;
    double offset;

    double distance(glm::dvec3 p) const { return glm::dot(normal, p) + offset; }
};

/// The light's six faces and its extra clip planes, in the space that `spaceFromWorld` (rigid) leads to.
std::vector<HalfSpace> lightVolume(const Light& light, const glm::dmat4& spaceFromWorld);

/// Corners of the intersection: every three planes meet in a point; the result is the points inside all planes.
std::vector<glm::dvec3> corners(const std::vector<HalfSpace>& volume);

struct Range {
    double nearest = 0.0, farthest = 0.0;
    bool empty() const { return !(farthest > nearest); }
};

/// Extent of the corners along -Z, cut to [nearPlane, farPlane].
Range depthRange(const std::vector<glm::dvec3>& corners, double nearPlane, double farPlane);

}  // namespace tyndall::test

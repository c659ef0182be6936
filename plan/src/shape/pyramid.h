// The volume of a spot light or projector: the pyramid of its field of view between its near and its far plane.
// Light space has the lamp at the origin, looks along -Z, +Y up.
#pragma once

#include <tyndall/light.h>

#include <array>
#include <glm/glm.hpp>

#include "shape/frustum_planes.h"
#include "shape/slopes.h"

namespace tyndall {

struct Pyramid {
    glm::dvec2 tanHalfFov{0.0};              ///< half of its width and height, for each metre along its axis
    double nearPlane = 0.0, farPlane = 0.0;  ///< metres along its axis
};

Pyramid pyramidOf(const Light& light);

/// The slopes of all its points.
SlopeRange slopesOf(const Pyramid& pyramid);

/// The slope of a light-space point before the lamp.
inline glm::dvec2 slopeOf(const Pyramid&, const glm::dvec3& lightPoint) {
    return glm::dvec2(lightPoint) / axisOf(lightPoint);
}

/// The light-space point `axis` metres along the axis that has this slope.
inline glm::dvec3 pointAt(const Pyramid&, const glm::dvec2& slope, double axis) {
    return axis * glm::dvec3(slope, -1.0);
}

/// Whether the light-space point lies before the lamp and its slope in the range.
bool holds(const Pyramid& pyramid, const SlopeRange& slopes, const glm::dvec3& lightPoint);

/// Light-space half space of the points before the lamp whose slope in x (`component` 0) or y (1) is above, or below,
/// the bound. The normal has no unit length.
glm::dvec4 slopePlane(const Pyramid& pyramid, int component, double bound, Keep keep);

/// The light-space planes of these slopes and distances along the axis. The sides have no unit normals.
FrustumPlanes frustumPlanes(const Pyramid& pyramid, const SlopeRange& slopes, double near, double far);

/// All of the pyramid, as frustumPlanes().
FrustumPlanes planesOf(const Pyramid& pyramid);

/// The corners of its cross-section `axis` metres along its axis: bit 0 of the number is set at the right, bit 1 at the
/// top.
std::array<glm::dvec3, 4> cornersAt(const Pyramid& pyramid, double axis);

/// The corners of the near end, then those of the far end (bit 2), in cornersAt()'s order.
std::array<glm::dvec3, 8> cornersOf(const Pyramid& pyramid);

/// Metres from the lamp to the farthest corner.
double maxDistance(const Pyramid& pyramid);

/// Radians between its axis and its edges.
double halfDiagonalAngle(const Pyramid& pyramid);

/// Its smaller width over the distance along its axis.
double narrowness(const Pyramid& pyramid);

struct Sphere {
    glm::dvec3 centre{0.0};
    double radius = 0.0;
};

/// The smallest sphere that holds it, in light space, plus 1e-9 of its radius for rounding.
Sphere boundingSphere(const Pyramid& pyramid);

/// Metres along its axis of its farthest point on a light-space plane, whose positive side has the lamp; at most the
/// far plane.
double maxAxisOn(const glm::dvec4& plane, const Pyramid& pyramid);

}  // namespace tyndall

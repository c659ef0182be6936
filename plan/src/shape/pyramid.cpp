#include "shape/pyramid.h"

#include <algorithm>
#include <cmath>

namespace tyndall {

glm::dvec2 tanHalfFov(const Light& light) {
    return glm::tan(0.5 * light.fov);
}

double maxDistance(const Light& light) {
    return maxDistance(pyramidOf(light));
}

Pyramid pyramidOf(const Light& light) {
    return {tanHalfFov(light), light.nearPlane, light.farPlane};
}

SlopeRange slopesOf(const Pyramid& pyramid) {
    return {-pyramid.tanHalfFov, pyramid.tanHalfFov};
}

bool holds(const Pyramid&, const SlopeRange& slopes, const glm::dvec3& lightPoint) {
    const double w = axisOf(lightPoint);
    return w > 0.0 && glm::all(glm::lessThanEqual(slopes.min * w, glm::dvec2(lightPoint))) &&
           glm::all(glm::lessThanEqual(glm::dvec2(lightPoint), slopes.max * w));
}

glm::dvec4 slopePlane(const Pyramid&, int component, double bound, Keep keep) {
    const auto sign = static_cast<double>(keep);
    glm::dvec4 plane(0.0, 0.0, sign * bound, 0.0);  // sign * (x - bound * w), w = -z
    plane[component] = sign;
    return plane;
}

FrustumPlanes frustumPlanes(const Pyramid& pyramid, const SlopeRange& slopes, double near, double far) {
    return {slopePlane(pyramid, 0, slopes.min.x, Keep::Above),
            slopePlane(pyramid, 0, slopes.max.x, Keep::Below),
            slopePlane(pyramid, 1, slopes.min.y, Keep::Above),
            slopePlane(pyramid, 1, slopes.max.y, Keep::Below),
            axisPlane(near, Keep::Above),
            axisPlane(far, Keep::Below)};
}

FrustumPlanes planesOf(const Pyramid& pyramid) {
    return frustumPlanes(pyramid, slopesOf(pyramid), pyramid.nearPlane, pyramid.farPlane);
}

std::array<glm::dvec3, 4> cornersAt(const Pyramid& pyramid, double axis) {
    std::array<glm::dvec3, 4> corners;
    const glm::dvec2 slope = pyramid.tanHalfFov;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = pointAt(pyramid, {(i & 1) ? slope.x : -slope.x, (i & 2) ? slope.y : -slope.y}, axis);
    return corners;
}

std::array<glm::dvec3, 8> cornersOf(const Pyramid& pyramid) {
    std::array<glm::dvec3, 8> corners;
    const std::array<glm::dvec3, 4> near = cornersAt(pyramid, pyramid.nearPlane);
    const std::array<glm::dvec3, 4> far = cornersAt(pyramid, pyramid.farPlane);
    std::copy(near.begin(), near.end(), corners.begin());
    std::copy(far.begin(), far.end(), corners.begin() + 4);
    return corners;
}

double maxDistance(const Pyramid& pyramid) {
    return pyramid.farPlane * glm::length(glm::dvec3(pyramid.tanHalfFov, 1.0));
}

double halfDiagonalAngle(const Pyramid& pyramid) {
    return std::atan(glm::length(pyramid.tanHalfFov));
}

double narrowness(const Pyramid& pyramid) {
    return 2.0 * std::min(pyramid.tanHalfFov.x, pyramid.tanHalfFov.y);
}

Sphere boundingSphere(const Pyramid& pyramid) {
    // The sphere through all eight corners, with its centre on the axis: the centre is as far from the near corners as
    // from the far ones. If that centre lies beyond the far plane, the far rectangle's own circle is smaller.
    const double k = 1.0 + glm::dot(pyramid.tanHalfFov, pyramid.tanHalfFov);
    const double along = std::min(0.5 * (pyramid.nearPlane + pyramid.farPlane) * k, pyramid.farPlane);
    const double out = pyramid.farPlane - along;
    const double radius = std::sqrt(out * out + (k - 1.0) * pyramid.farPlane * pyramid.farPlane) * (1.0 + 1e-9);
    return {{0.0, 0.0, -along}, radius};
}

double maxAxisOn(const glm::dvec4& plane, const Pyramid& pyramid) {
    // The plane meets the edge with slope s at w = d / (n.z - dot(n.xy, s)).
    const double grazing = plane.z - glm::dot(glm::abs(glm::dvec2(plane)), pyramid.tanHalfFov);
    return grazing * pyramid.farPlane > plane.w ? plane.w / grazing : pyramid.farPlane;
}

}  // namespace tyndall

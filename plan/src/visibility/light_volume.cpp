#include "visibility/light_volume.h"

#include <algorithm>
#include <cmath>

#include "geometry/convex_polyhedron.h"
#include "shape/light_shape.h"
#include "shape/slide.h"

namespace tyndall {
namespace {

// A volume only touches a plane if it extends beyond it by less than this share of the scene's size. Doubles resolve
// 1e-16, the uploaded floats 6e-8: so thin a part cannot show.
constexpr double touching = 1e-12;

ConvexPolyhedron solidOf(const LightShape& shape, const LightPose& pose) {
    std::array<glm::dvec3, 8> corners = cornersOf(shape);
    for (glm::dvec3& corner : corners) corner = glm::dvec3(pose.viewFromLight * glm::dvec4(corner, 1.0));
    return hexahedron(corners);
}

bool cutAll(ConvexPolyhedron& solid, std::span<const glm::dvec4> planes, double tolerance) {
    return std::all_of(planes.begin(), planes.end(),
                       [&](const glm::dvec4& plane) { return cut(solid, plane, tolerance); });
}

bool holds(const glm::dvec4& plane, const ConvexPolyhedron& solid) {
    return std::all_of(solid.vertices.begin(), solid.vertices.end(),
                       [&](const glm::dvec3& p) { return glm::dot(plane, glm::dvec4(p, 1.0)) >= 0.0; });
}

double size(const ConvexPolyhedron& solid) {
    double max = 0.0;
    for (const glm::dvec3& p : solid.vertices) max = std::max(max, glm::length(p));
    return max;
}

glm::dvec4 before(double depth) {
    return {0.0, 0.0, 1.0, depth};
}

// Cuts the solid down to the view's own depth range.
Verdict cutByDepth(ConvexPolyhedron& solid, const View& view, double tolerance) {
    const bool behindEye =
        std::all_of(solid.vertices.begin(), solid.vertices.end(), [](const glm::dvec3& p) { return p.z >= 0.0; });
    if (!cut(solid, {0.0, 0.0, -1.0, -view.nearPlane}, tolerance))
        return behindEye ? Verdict::BehindEye : Verdict::BeforeNear;
    if (std::isfinite(view.farPlane) && !cut(solid, before(view.farPlane), tolerance)) return Verdict::BeyondFar;
    return Verdict::Drawn;
}

Verdict measure(LightVolume& volume, const LightShape& shape, const View& view, const LightPose& pose,
                std::span<const glm::dvec4> walls, std::span<const glm::dvec4> beam, ConvexPolyhedron& seen) {
    ConvexPolyhedron solid = solidOf(shape, pose);
    const double tolerance = touching * size(solid);
    if (!cutAll(solid, volume.clipPlanes, tolerance)) return Verdict::ClipPlanes;
    volume.axisNear = shape.farPlane;
    for (const glm::dvec3& p : solid.vertices) {
        volume.axisNear = std::min(volume.axisNear, axisOf(pose, p));
        volume.axisFar = std::max(volume.axisFar, axisOf(pose, p));
    }
    if (const Verdict hidden = cutByDepth(solid, view, tolerance); hidden != Verdict::Drawn) return hidden;

    // Depths of the whole volume, not of its visible part: slices must not move when the view turns about its axis or
    // the picture's shape changes.
    const auto [farthest, nearest] = std::minmax_element(solid.vertices.begin(), solid.vertices.end(),
                                                         [](const auto& a, const auto& b) { return a.z < b.z; });
    volume.nearDepth = std::max(-nearest->z, view.nearPlane);
    volume.farDepth = std::min(-farthest->z, view.farPlane);
    volume.farShown = std::min(volume.farDepth, view.sceneDepth);

    ConvexPolyhedron within = solid;
    const InlineVector<glm::dvec4, 4> sides = viewSides(view, guardBand);
    for (const glm::dvec4& plane : sides)
        if (!holds(plane, solid)) volume.guard.push_back(plane);
    cutAll(within, volume.guard, tolerance);
    volume.boundsMin = volume.boundsMax = glm::dvec2(within.vertices.front());
    for (const glm::dvec3& p : within.vertices) {
        volume.boundsMin = glm::min(volume.boundsMin, glm::dvec2(p));
        volume.boundsMax = glm::max(volume.boundsMax, glm::dvec2(p));
    }

    volume.nearLit = volume.nearDepth;
    volume.farLit = volume.farDepth;
    seen = solid;
    if (!cutAll(seen, walls, tolerance)) return Verdict::BehindWalls;
    if (!cutAll(seen, beam, tolerance)) return Verdict::DarkCookie;
    const auto [lastLit, firstLit] = std::minmax_element(seen.vertices.begin(), seen.vertices.end(),
                                                         [](const auto& a, const auto& b) { return a.z < b.z; });
    volume.nearLit = std::max(-firstLit->z, view.nearPlane);
    volume.farLit = std::min(-lastLit->z, view.farPlane);
    for (const glm::dvec3& p : seen.vertices) volume.axisLit = std::max(volume.axisLit, axisOf(pose, p));
    for (const glm::dvec4& wall : walls) volume.walls.push_back(wall);
    for (const glm::dvec4& side : beam) volume.beam.push_back(side);
    const auto shown = [&](ConvexPolyhedron& part) {
        if (!cut(part, before(view.sceneDepth), tolerance)) return Verdict::BehindScene;
        return cutAll(part, viewSides(view, 1.0), tolerance) ? Verdict::Drawn : Verdict::BesideView;
    };
    const Verdict hidden = shown(seen);
    if (hidden == Verdict::Drawn || walls.empty()) return hidden;
    return shown(solid) == Verdict::Drawn ? Verdict::BehindWalls : hidden;
}

}  // namespace

VolumePlanes boundingPlanes(const LightVolume& volume) {
    VolumePlanes planes;
    for (const glm::dvec4& plane : volume.shape.all()) planes.push_back(plane);
    for (const glm::dvec4& plane : volume.clipPlanes) planes.push_back(plane);
    return planes;
}

InlineVector<glm::dvec4, 4> viewSides(const View& view, double width) {
    const glm::dmat4 rows = glm::transpose(view.clipFromView);
    InlineVector<glm::dvec4, 4> sides;
    for (int axis = 0; axis < 2; ++axis)
        for (const double sign : {1.0, -1.0}) sides.push_back(unitPlane(width * rows[3] + sign * rows[axis]));
    return sides;
}

InlineVector<glm::dvec4, 8> beamSides(const Light& light, const LightPose& pose, const TextureSurvey& cookie) {
    // A plane that saves less than this share of the slide's side does not pay.
    constexpr double minSpared = 0.02;
    const LightShape shape = shapeOf(light);
    const glm::dvec2 along[] = {{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}};
    const double whole[][2] = {{0.0, 1.0}, {0.0, 1.0}, {0.0, 2.0}, {-1.0, 1.0}};
    InlineVector<glm::dvec4, 8> sides;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2& d = along[i];
        const auto plane = [&](double bound, double sign) {
            return unitPlane(sign * slidePlane(shape, d, bound) * pose.lightFromView);
        };
        if (cookie.litMin[i] > whole[i][0] + minSpared) sides.push_back(plane(cookie.litMin[i] - 1e-4, 1.0));
        if (cookie.litMax[i] < whole[i][1] - minSpared) sides.push_back(plane(cookie.litMax[i] + 1e-4, -1.0));
    }
    return sides;
}

LightVolume lightVolume(const Light& light, const View& view, const LightPose& pose, std::span<const glm::dvec4> walls,
                        std::span<const glm::dvec4> beam, ConvexPolyhedron& seen) {
    const LightShape shape = shapeOf(light);
    LightVolume volume;
    // A plane is a row vector: the plane for p_light = M p_view becomes plane * M for p_view.
    volume.shape =
        changed(planesOf(shape), [&](const glm::dvec4& plane) { return unitPlane(plane * pose.lightFromView); });
    for (const glm::dvec4& plane : light.clipPlanes) volume.clipPlanes.push_back(viewPlane(plane, view.worldFromView));
    volume.hidden = measure(volume, shape, view, pose, walls, beam, seen);
    return volume;
}

Verdict hiddenBySphere(const Light& light, const View& view, const LightPose& pose, std::span<const glm::dvec4> sides) {
    const Sphere sphere = boundingSphere(shapeOf(light));
    const double radius = sphere.radius;
    const glm::dvec3 centre(pose.viewFromLight * glm::dvec4(sphere.centre, 1.0));
    const double depth = -centre.z;
    if (depth + radius < 0.0) return Verdict::BehindEye;
    if (depth + radius < view.nearPlane) return Verdict::BeforeNear;
    if (depth - radius > view.farPlane) return Verdict::BeyondFar;
    if (depth - radius > view.sceneDepth) return Verdict::BehindScene;
    for (const glm::dvec4& side : sides)
        if (glm::dot(side, glm::dvec4(centre, 1.0)) < -radius) return Verdict::BesideView;
    return Verdict::Drawn;
}

}  // namespace tyndall

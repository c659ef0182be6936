#include "visibility/light_volume.h"

#include <algorithm>
#include <cmath>

#include "geometry/convex_polyhedron.h"

namespace tyndall {
namespace {

// Shares of the scene's size below which a volume counts as only touching a plane. Doubles carry 1e-16;
// what is thinner than this disappears in the floats of the upload a million times over.
constexpr double touching = 1e-12;

ConvexPolyhedron pyramid(const Light& light, const LightPose& pose) {
    const glm::dvec2 slope = glm::tan(0.5 * light.fov);
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double axis = (i & 4) ? light.farPlane : light.nearPlane;
        const glm::dvec3 corner((i & 1) ? slope.x : -slope.x, (i & 2) ? slope.y : -slope.y, -1.0);
        corners[i] = glm::dvec3(pose.viewFromLight * glm::dvec4(corner * axis, 1.0));
    }
    return hexahedron(corners);
}

template <class Planes>
void addPyramidPlanes(Planes& planes, const Light& light, const LightPose& pose) {
    const glm::dvec2 slope = glm::tan(0.5 * light.fov);
    const glm::dvec4 lightSpace[] = {
        {1.0, 0.0, -slope.x, 0.0},  {-1.0, 0.0, -slope.x, 0.0},         {0.0, 1.0, -slope.y, 0.0},
        {0.0, -1.0, -slope.y, 0.0}, {0.0, 0.0, -1.0, -light.nearPlane}, {0.0, 0.0, 1.0, light.farPlane},
    };
    // A plane is a row vector: what keeps p_light = M p_view keeps p_view under plane * M.
    for (const glm::dvec4& plane : lightSpace) planes.push_back(unitPlane(plane * pose.lightFromView));
}

bool cutAll(ConvexPolyhedron& solid, std::span<const glm::dvec4> planes, double tolerance) {
    return std::all_of(planes.begin(), planes.end(),
                       [&](const glm::dvec4& plane) { return cut(solid, plane, tolerance); });
}

template <class Planes>
std::span<const glm::dvec4> spanOf(const Planes& planes) {
    return {planes.data(), planes.size()};
}

bool holds(const glm::dvec4& plane, const ConvexPolyhedron& solid) {
    return std::all_of(solid.vertices.begin(), solid.vertices.end(),
                       [&](const glm::dvec3& p) { return glm::dot(plane, glm::dvec4(p, 1.0)) >= 0.0; });
}

double size(const ConvexPolyhedron& solid) {
    double most = 0.0;
    for (const glm::dvec3& p : solid.vertices) most = std::max(most, glm::length(p));
    return most;
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

Verdict measure(LightVolume& volume, const Light& light, const View& view, const LightPose& pose,
                std::span<const glm::dvec4> walls, std::span<const glm::dvec4> beam, ConvexPolyhedron& seen) {
    ConvexPolyhedron solid = pyramid(light, pose);
    const double tolerance = touching * size(solid);
    for (std::size_t i = 6; i < volume.planes.size(); ++i)
        if (!cut(solid, volume.planes[i], tolerance)) return Verdict::ClipPlanes;
    volume.axisNear = light.farPlane;
    for (const glm::dvec3& p : solid.vertices) {
        volume.axisNear = std::min(volume.axisNear, axisOf(pose, p));
        volume.axisFar = std::max(volume.axisFar, axisOf(pose, p));
    }
    if (const Verdict hidden = cutByDepth(solid, view, tolerance); hidden != Verdict::Drawn) return hidden;

    // The whole volume's depths, not those of its visible part: slices must not move when the view turns
    // about its axis or the picture's shape changes.
    const auto [farthest, nearest] = std::minmax_element(solid.vertices.begin(), solid.vertices.end(),
                                                         [](const auto& a, const auto& b) { return a.z < b.z; });
    volume.nearDepth = std::max(-nearest->z, view.nearPlane);
    volume.farDepth = std::min(-farthest->z, view.farPlane);
    volume.farShown = std::min(volume.farDepth, view.sceneDepth);

    ConvexPolyhedron within = solid;
    const InlineVector<glm::dvec4, 4> sides = viewSides(view, guardBand);
    for (const glm::dvec4& plane : sides)
        if (!holds(plane, solid)) volume.guard.push_back(plane);
    cutAll(within, spanOf(volume.guard), tolerance);
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
    for (const glm::dvec4& wall : walls) volume.planes.push_back(wall);
    volume.walls = walls.size();
    for (const glm::dvec4& side : beam) volume.beam.push_back(side);
    const auto shown = [&](ConvexPolyhedron& part) {
        if (!cut(part, before(view.sceneDepth), tolerance)) return Verdict::BehindScene;
        return cutAll(part, spanOf(viewSides(view, 1.0)), tolerance) ? Verdict::Drawn : Verdict::BesideView;
    };
    const Verdict hidden = shown(seen);
    if (hidden == Verdict::Drawn || walls.empty()) return hidden;
    return shown(solid) == Verdict::Drawn ? Verdict::BehindWalls : hidden;
}

}  // namespace

InlineVector<glm::dvec4, 4> viewSides(const View& view, double width) {
    const glm::dmat4 rows = glm::transpose(view.clipFromView);
    InlineVector<glm::dvec4, 4> sides;
    for (int axis = 0; axis < 2; ++axis)
        for (const double sign : {1.0, -1.0}) sides.push_back(unitPlane(width * rows[3] + sign * rows[axis]));
    return sides;
}

InlineVector<glm::dvec4, 8> beamSides(const Light& light, const LightPose& pose, const TextureSurvey& cookie) {
    // Less than this of the slide's side is not worth a plane.
    constexpr double leastSpared = 0.02;
    const glm::dvec2 scale = 0.5 / glm::tan(0.5 * light.fov);
    const glm::dvec2 along[] = {{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}};
    const double whole[][2] = {{0.0, 1.0}, {0.0, 1.0}, {0.0, 2.0}, {-1.0, 1.0}};
    InlineVector<glm::dvec4, 8> sides;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2& d = along[i];
        // At distance w along the axis u = x scale.x / w + 0.5 and v = 0.5 - y scale.y / w; times w, d.x u + d.y v -
        // bound is a plane through the lamp.
        const auto plane = [&](double bound, double sign) {
            const glm::dvec4 side(d.x * scale.x, -d.y * scale.y, bound - 0.5 * (d.x + d.y), 0.0);
            return unitPlane(sign * side * pose.lightFromView);
        };
        if (cookie.litLeast[i] > whole[i][0] + leastSpared) sides.push_back(plane(cookie.litLeast[i] - 1e-4, 1.0));
        if (cookie.litMost[i] < whole[i][1] - leastSpared) sides.push_back(plane(cookie.litMost[i] + 1e-4, -1.0));
    }
    return sides;
}

LightVolume lightVolume(const Light& light, const View& view, const LightPose& pose, std::span<const glm::dvec4> walls,
                        std::span<const glm::dvec4> beam, ConvexPolyhedron& seen) {
    LightVolume volume;
    addPyramidPlanes(volume.planes, light, pose);
    for (const glm::dvec4& plane : light.clipPlanes) volume.planes.push_back(viewPlane(plane, view.worldFromView));
    volume.hidden = measure(volume, light, view, pose, walls, beam, seen);
    return volume;
}

Verdict hiddenAtAGlance(const Light& light, const View& view, const LightPose& pose,
                        std::span<const glm::dvec4> sides) {
    // The sphere through the eight corners of a pyramid's stump, centred on its axis: its centre is as far from the
    // near corners as from the far ones. Where that lies beyond the far plane, the far rectangle's own circle does.
    const glm::dvec2 slope = glm::tan(0.5 * light.fov);
    const double k = 1.0 + glm::dot(slope, slope);
    const double along = std::min(0.5 * (light.nearPlane + light.farPlane) * k, light.farPlane);
    const double out = light.farPlane - along;
    const double radius = std::sqrt(out * out + (k - 1.0) * light.farPlane * light.farPlane) * (1.0 + 1e-9);
    const glm::dvec3 centre(pose.viewFromLight * glm::dvec4(0.0, 0.0, -along, 1.0));
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

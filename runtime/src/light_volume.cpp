#include "light_volume.h"

#include <algorithm>
#include <cmath>

#include "convex_polyhedron.h"

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

void addPyramidPlanes(std::vector<glm::dvec4>& planes, const Light& light, const LightPose& pose) {
    const glm::dvec2 slope = glm::tan(0.5 * light.fov);
    const glm::dvec4 lightSpace[] = {
        {1.0, 0.0, -slope.x, 0.0},  {-1.0, 0.0, -slope.x, 0.0},         {0.0, 1.0, -slope.y, 0.0},
        {0.0, -1.0, -slope.y, 0.0}, {0.0, 0.0, -1.0, -light.nearPlane}, {0.0, 0.0, 1.0, light.farPlane},
    };
    // A plane is a row vector: what keeps p_light = M p_view keeps p_view under plane * M.
    for (const glm::dvec4& plane : lightSpace) planes.push_back(unitPlane(plane * pose.lightFromView));
}

// Left, right, top and bottom of the clip volume |x| <= width * w, |y| <= width * w.
std::vector<glm::dvec4> viewSides(const View& view, double width) {
    const glm::dmat4 rows = glm::transpose(view.clipFromView);
    std::vector<glm::dvec4> sides;
    for (int axis = 0; axis < 2; ++axis)
        for (const double sign : {1.0, -1.0}) sides.push_back(unitPlane(width * rows[3] + sign * rows[axis]));
    return sides;
}

bool cutAll(ConvexPolyhedron& solid, const std::vector<glm::dvec4>& planes, double tolerance) {
    return std::all_of(planes.begin(), planes.end(),
                       [&](const glm::dvec4& plane) { return cut(solid, plane, tolerance); });
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

// Cuts the solid down to what the view's depth range shows of it.
Hidden cutByDepth(ConvexPolyhedron& solid, const View& view, double tolerance) {
    const auto before = [](double depth) { return glm::dvec4(0.0, 0.0, 1.0, depth); };
    const bool behindEye =
        std::all_of(solid.vertices.begin(), solid.vertices.end(), [](const glm::dvec3& p) { return p.z >= 0.0; });
    if (!cut(solid, {0.0, 0.0, -1.0, -view.nearPlane}, tolerance))
        return behindEye ? Hidden::BehindEye : Hidden::BeforeNear;
    if (std::isfinite(view.farPlane) && !cut(solid, before(view.farPlane), tolerance)) return Hidden::BeyondFar;
    if (!cut(solid, before(view.sceneDepth), tolerance)) return Hidden::BehindScene;
    return Hidden::No;
}

Hidden measure(LightVolume& volume, const Light& light, const View& view, const LightPose& pose) {
    ConvexPolyhedron solid = pyramid(light, pose);
    const double tolerance = touching * size(solid);
    for (std::size_t i = 6; i < volume.planes.size(); ++i)
        if (!cut(solid, volume.planes[i], tolerance)) return Hidden::ClipPlanes;
    if (const Hidden hidden = cutByDepth(solid, view, tolerance); hidden != Hidden::No) return hidden;

    // The whole volume's depths, not those of its visible part: slices must not move when the view turns
    // about its axis or the picture's shape changes.
    const auto [farthest, nearest] = std::minmax_element(solid.vertices.begin(), solid.vertices.end(),
                                                         [](const auto& a, const auto& b) { return a.z < b.z; });
    volume.nearDepth = std::max(-nearest->z, view.nearPlane);
    volume.farDepth = std::min({-farthest->z, view.farPlane, view.sceneDepth});

    ConvexPolyhedron visible = solid;
    if (!cutAll(visible, viewSides(view, 1.0), tolerance)) return Hidden::BesideView;
    std::erase_if(volume.guard, [&](const glm::dvec4& plane) { return holds(plane, solid); });
    cutAll(solid, volume.guard, tolerance);
    volume.boundsMin = volume.boundsMax = glm::dvec2(solid.vertices.front());
    for (const glm::dvec3& p : solid.vertices) {
        volume.boundsMin = glm::min(volume.boundsMin, glm::dvec2(p));
        volume.boundsMax = glm::max(volume.boundsMax, glm::dvec2(p));
    }
    return Hidden::No;
}

}  // namespace

LightVolume lightVolume(const Light& light, const View& view, const LightPose& pose) {
    LightVolume volume;
    volume.planes.reserve(6 + light.clipPlanes.size());
    addPyramidPlanes(volume.planes, light, pose);
    for (const glm::dvec4& plane : light.clipPlanes) volume.planes.push_back(viewPlane(plane, view.worldFromView));
    volume.guard = viewSides(view, guardBand);
    volume.hidden = measure(volume, light, view, pose);
    if (volume.hidden != Hidden::No) volume.nearDepth = volume.farDepth = 0.0;
    return volume;
}

}  // namespace tyndall

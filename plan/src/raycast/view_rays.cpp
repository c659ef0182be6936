#include "raycast/view_rays.h"

namespace tyndall {

// With the rows r of clipFromView and w = scale.x + depth * scale.y, a point (X, Y, -depth) of view space lies at clip
// coordinates (x, y) if
//
//   A (X, Y) = (x, y) * scale.x - (r0.w, r1.w) + depth * ((x, y) * scale.y + (r0.z, r1.z)),   A = upper left of r
ViewRays viewRays(const View& view, const LightPose& pose) {
    const glm::dmat4 rows = glm::transpose(view.clipFromView);
    const glm::dmat2 inverse = glm::inverse(glm::dmat2(view.clipFromView));
    ViewRays rays;
    rays.scale = {rows[3].w, -rows[3].z};
    const glm::dmat3 rotation(pose.lightFromView);
    const auto inLight = [&](const glm::dvec2& xy, double depthRate, double clipZ) {
        return glm::dvec4(rotation * glm::dvec3(xy, -depthRate),
                          glm::dot(glm::dvec2(rows[2]), xy) - rows[2].z * depthRate + clipZ);
    };
    const glm::dvec2 shift(rows[0].w, rows[1].w), slope(rows[0].z, rows[1].z);
    rays.origin[0] = inLight(inverse * -shift, 0.0, rows[2].w) + glm::dvec4(glm::dvec3(pose.lightFromView[3]), 0.0);
    rays.direction[0] = inLight(inverse * slope, 1.0, 0.0);
    for (int axis = 0; axis < 2; ++axis) {
        rays.origin[static_cast<std::size_t>(axis + 1)] = inLight(inverse[axis] * rays.scale.x, 0.0, 0.0);
        rays.direction[static_cast<std::size_t>(axis + 1)] = inLight(inverse[axis] * rays.scale.y, 0.0, 0.0);
    }
    return rays;
}

}  // namespace tyndall

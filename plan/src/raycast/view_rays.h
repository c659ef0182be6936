// The rays of a view's pixels.
#pragma once

#include <tyndall/view.h>

#include <array>
#include <glm/glm.hpp>

#include "visibility/view_pose.h"

namespace tyndall {

/// The ray of the pixel at clip coordinates (x, y) holds the points origin(x, y) + depth * direction(x, y) of light
/// space, at every view depth. Both are linear: [0] + x [1] + y [2]. The last component is clip-space z, so that
///
///   stored depth * (scale.x + depth * scale.y) = origin.w + depth * direction.w
struct ViewRays {
    std::array<glm::dvec4, 3> origin, direction;
    glm::dvec2 scale{0.0};
};

ViewRays viewRays(const View& view, const LightPose& pose);

}  // namespace tyndall

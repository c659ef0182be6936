// What the picture shows of a light's volume.
#pragma once

#include <tyndall/light.h>
#include <tyndall/surroundings.h>
#include <tyndall/view.h>

#include <glm/glm.hpp>
#include <optional>

#include "geometry/convex_polyhedron.h"
#include "visibility/view_pose.h"

namespace tyndall {

struct SeenAir {
    bool any = false;                         ///< false: surfaces hide all of it
    double nearDepth = 0.0, farDepth = 0.0;   ///< metres of view depth
    double axisNear = 0.0, axisFar = 0.0;     ///< metres along the light's axis
    glm::dvec2 slideMin{0.0}, slideMax{0.0};  ///< light-space x / w and y / w: slopes, the field of view is +-tan
    double longest = 0.0;                     ///< metres: no view ray runs farther through it
};

/// `seen` is what the view's frustum shows of the volume. A tile shows what lies before its farthest surface.
/// Conservative: nothing that a pixel shows lies outside of the answer.
SeenAir seenAir(const ConvexPolyhedron& seen, const View& view, const LightPose& pose,
                const std::optional<DepthTiles>& tiles);

}  // namespace tyndall

// The part of a light's volume that the picture shows.
#pragma once

#include <tyndall/light.h>
#include <tyndall/surroundings.h>
#include <tyndall/view.h>

#include <glm/glm.hpp>
#include <optional>

#include "geometry/convex_polyhedron.h"
#include "shape/light_shape.h"
#include "visibility/view_pose.h"

namespace tyndall {

struct SeenAir {
    bool any = false;                        ///< false: surfaces hide all of it
    double nearDepth = 0.0, farDepth = 0.0;  ///< metres of view depth
    double axisNear = 0.0, axisFar = 0.0;    ///< metres along the light's axis
    SlopeRange slopes;                       ///< as the lamp sees it
    double maxLength = 0.0;                  ///< metres: maximum length of a view ray in it
};

/// `seen`: the part of the volume that the view's frustum shows. A tile shows the air before its farthest surface.
/// Conservative: the result holds every point that a pixel shows.
SeenAir seenAir(const ConvexPolyhedron& seen, const LightShape& shape, const View& view, const LightPose& pose,
                const std::optional<DepthTiles>& tiles);

}  // namespace tyndall

// The eye that the shafts are seen from.
#pragma once

#include <glm/glm.hpp>

namespace tyndall {

/// A camera. View space has the eye at the origin and looks along -Z, +Y up; clip space is Vulkan's.
struct View {
    glm::dmat4 worldFromView{1.0};   ///< rigid
    glm::dmat4 clipFromView{1.0};    ///< any Vulkan projection; reversed and infinite depth are fine
    double nearPlane = 0.1;          ///< metres of depth, > 0
    double farPlane = 1000.0;        ///< metres of depth, > nearPlane; infinity is allowed
    double sceneDepth = 1.0e300;     ///< depth of the farthest visible surface where known: no slice behind it
    bool orthographic = false;       ///< rays are parallel: a slab is as long as it is thick
};

/// A perspective view with reversed depth: 1 at nearPlane, 0 at farPlane (at infinity where that is
/// infinite). `verticalFov` in radians in (0, pi), `aspect` width over height.
View perspectiveView(const glm::dmat4& worldFromView, double verticalFov, double aspect, double nearPlane,
                     double farPlane);

/// An orthographic view with reversed depth; half extents in metres.
View orthographicView(const glm::dmat4& worldFromView, double halfWidth, double halfHeight, double nearPlane,
                      double farPlane);

}  // namespace tyndall

// The eye that the shafts are seen from.
#pragma once

#include <glm/glm.hpp>

namespace tyndall {

/// A camera. View space has the eye at the origin and looks along -Z, +Y up; clip space is Vulkan's.
/// Every number but farPlane must be finite.
struct View {
    glm::dmat4 worldFromView{1.0};  ///< rigid, as Light::worldFromLight
    glm::dmat4 clipFromView{1.0};   ///< any invertible Vulkan projection whose last row is (0, 0, -k, 0), or
                                    ///< (0, 0, 0, k) where orthographic, k > 0; up to 179 degrees or 1e9 m
                                    ///< wide; shifted, rotated, reversed and infinite-depth ones are fine
    double nearPlane = 0.1;         ///< metres of depth, > 0
    double farPlane = 1000.0;       ///< metres of depth, > nearPlane; may be infinite unless orthographic
    double sceneDepth = 1.0e300;    ///< depth of the farthest visible surface if known, > 0: no slice is drawn behind
                                    ///< it
    bool orthographic = false;      ///< rays are parallel: a slab is as long as it is thick
};

/// A perspective view with reversed depth: 1 at nearPlane, 0 at farPlane (at infinity where that is
/// infinite). `verticalFov` in radians in (0, pi), `aspect` width over height, > 0; outside these bounds the
/// projection is NaN, which plan() rejects.
View perspectiveView(const glm::dmat4& worldFromView, double verticalFov, double aspect, double nearPlane,
                     double farPlane);

/// An orthographic view with reversed depth; half extents in metres, > 0, or else as above.
View orthographicView(const glm::dmat4& worldFromView, double halfWidth, double halfHeight, double nearPlane,
                      double farPlane);

}  // namespace tyndall

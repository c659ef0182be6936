// The part of a light's pyramid that a view can see, in view space.
#pragma once

#include <tyndall/light.h>
#include <tyndall/view.h>

#include <glm/glm.hpp>
#include <vector>

#include "view_pose.h"

namespace tyndall {

/// What keeps a volume out of the picture.
enum class Hidden {
    No,
    ClipPlanes,  ///< the light's own clip planes leave nothing
    BehindEye,
    BeforeNear,  ///< in front of the eye, but not beyond the view's near plane
    BeyondFar,
    BehindScene,  ///< behind the farthest visible surface
    BesideView,   ///< outside the sides of the view's frustum
};

struct LightVolume {
    Hidden hidden = Hidden::No;  ///< anything else leaves the depths and bounds at zero
    /// Unit normals, keeping dot(n, p) + d >= 0: left, right, bottom, top, near, far of the light's pyramid,
    /// then its clip planes.
    std::vector<glm::dvec4> planes;
    /// Those sides of the view's frustum, widened by guardBand, that the volume crosses.
    std::vector<glm::dvec4> guard;
    double nearDepth = 0.0, farDepth = 0.0;     ///< metres of view depth
    glm::dvec2 boundsMin{0.0}, boundsMax{0.0};  ///< view-space x and y of what lies inside the guard band
};

/// Slices are cut this many half widths from the middle of the view. Beyond the picture nothing shows, but
/// a rasterizer interpolates in floats: over a polygon a kilometre wide the light-space position would be
/// off by a tenth of a millimetre in the middle of the picture. Well outside it, so that nothing a driver
/// does at the picture's edge, multisampling included, ever meets this cut.
inline constexpr double guardBand = 8.0;

LightVolume lightVolume(const Light& light, const View& view, const LightPose& pose);

}  // namespace tyndall

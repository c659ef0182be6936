// The part of a light's pyramid that a view can see, in view space.
#pragma once

#include <tyndall/light.h>
#include <tyndall/plan.h>
#include <tyndall/view.h>

#include <glm/glm.hpp>
#include <span>

#include "geometry/convex_polyhedron.h"
#include "geometry/inline_vector.h"
#include "visibility/view_pose.h"

namespace tyndall {

struct LightVolume {
    Verdict hidden = Verdict::Drawn;  ///< of what the view's depth range has nothing, depths and bounds are zero
    /// Unit normals, keeping dot(n, p) + d >= 0: left, right, bottom, top, near, far of the light's pyramid,
    /// then its clip planes, then walls.
    InlineVector<glm::dvec4, 16> planes;
    std::size_t walls = 0;  ///< of the planes, the last ones
    /// Planes through the lamp outside of which its cookie is black, see beamSides().
    InlineVector<glm::dvec4, 8> beam;
    /// Those sides of the view's frustum, widened by guardBand, that the volume crosses.
    InlineVector<glm::dvec4, 4> guard;
    double nearDepth = 0.0, farDepth = 0.0;  ///< metres of view depth, whatever walls cut off
    double farShown = 0.0;                   ///< farDepth, but no deeper than View::sceneDepth
    double nearLit = 0.0, farLit = 0.0;      ///< metres of view depth, before the walls and in the beam
    double axisLit = 0.0;                    ///< metres along the light's axis to the farthest point before the walls
    glm::dvec2 boundsMin{0.0}, boundsMax{0.0};  ///< view-space x and y of what lies inside the guard band
    double axisNear = 0.0, axisFar = 0.0;       ///< metres along the light's axis: all that clip planes leave
};

/// Slices are cut this many half widths from the middle of the view. Beyond the picture nothing shows, but
/// a rasterizer interpolates in floats: over a polygon a kilometre wide the light-space position would be
/// off by a tenth of a millimetre in the middle of the picture. Well outside it, so that nothing a driver
/// does at the picture's edge, multisampling included, ever meets this cut.
inline constexpr double guardBand = 8.0;

/// Planes of view space that bound where the light's cookie lets light through; those that spare something.
InlineVector<glm::dvec4, 8> beamSides(const Light& light, const LightPose& pose, const TextureSurvey& cookie);

/// `walls`: planes of view space behind which the light does not come, see walls.h. `beam`: see beamSides(). `seen`
/// becomes what the view frustum shows of what is lit.
LightVolume lightVolume(const Light& light, const View& view, const LightPose& pose, std::span<const glm::dvec4> walls,
                        std::span<const glm::dvec4> beam, ConvexPolyhedron& seen);

/// Whether the whole pyramid can be told at a glance to lie outside of the view: Verdict::Drawn where it cannot.
/// Costs a tenth of what lightVolume() costs. `sides` are viewSides(view, 1).
Verdict hiddenAtAGlance(const Light& light, const View& view, const LightPose& pose, std::span<const glm::dvec4> sides);

/// Left, right, top and bottom of the clip volume |x| <= width * w, |y| <= width * w.
InlineVector<glm::dvec4, 4> viewSides(const View& view, double width);

/// Metres along the light's axis of a point in view space.
inline double axisOf(const LightPose& pose, const glm::dvec3& point) {
    return -(pose.lightFromView * glm::dvec4(point, 1.0)).z;
}

}  // namespace tyndall

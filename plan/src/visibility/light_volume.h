// The part of a light's volume that a view can see, in view space.
#pragma once

#include <tyndall/light.h>
#include <tyndall/plan.h>
#include <tyndall/view.h>

#include <glm/glm.hpp>
#include <span>

#include "geometry/convex_polyhedron.h"
#include "geometry/inline_vector.h"
#include "shape/frustum_planes.h"
#include "shape/slopes.h"
#include "visibility/view_pose.h"
#include "visibility/walls.h"

namespace tyndall {

/// The maximum that checkLight() accepts.
inline constexpr std::size_t maxClipPlanes = 6;

struct LightVolume {
    /// If the view's depth range shows none of the volume, depths and bounds are zero.
    Verdict hidden = Verdict::Drawn;
    // All planes keep dot(n, p) + d >= 0 and have unit normals.
    FrustumPlanes shape;                                 ///< of the light's shape
    InlineVector<glm::dvec4, maxClipPlanes> clipPlanes;  ///< the light's own
    InlineVector<glm::dvec4, maxWalls> walls;            ///< the lamp's light ends at them, see walls.h
    InlineVector<glm::dvec4, 8> beam;   ///< through the lamp; the cookie is black outside of them, see beamSides()
    InlineVector<glm::dvec4, 4> guard;  ///< sides of the view's frustum, widened by guardBand, that the volume crosses
    double nearDepth = 0.0, farDepth = 0.0;  ///< metres of view depth, including the part behind walls
    double farShown = 0.0;                   ///< farDepth, but no deeper than View::sceneDepth
    double nearLit = 0.0, farLit = 0.0;      ///< metres of view depth, before the walls and in the beam
    double axisLit = 0.0;                    ///< metres along the light's axis to the farthest point before the walls
    glm::dvec2 boundsMin{0.0}, boundsMax{0.0};  ///< view-space x and y of the part inside the guard band
    double axisNear = 0.0, axisFar = 0.0;       ///< metres along the light's axis: the volume after its clip planes
};

/// The planes that bound a light's volume, without walls: those of its shape, then its clip planes.
using VolumePlanes = InlineVector<glm::dvec4, 6 + maxClipPlanes>;
VolumePlanes boundingPlanes(const LightVolume& volume);

/// Slices are cut this many half widths from the middle of the view. A rasterizer interpolates in floats: over a
/// polygon a kilometre wide the light-space position would be off by a tenth of a millimetre in the middle of the
/// picture. The cut lies far outside of the picture, away from everything that a driver does at the picture's edge,
/// such as multisampling.
inline constexpr double guardBand = 8.0;

/// Planes of view space that bound the air that the cookie lets light into. Holds only planes that save something.
InlineVector<glm::dvec4, 8> beamSides(const Light& light, const LightPose& pose, const TextureSurvey& cookie);

/// `walls`: planes of view space at which the lamp's light ends, see walls.h. `beam`: see beamSides(). `seen` becomes
/// the lit part of the volume that the view's frustum shows.
LightVolume lightVolume(const Light& light, const View& view, const LightPose& pose, std::span<const glm::dvec4> walls,
                        std::span<const glm::dvec4> beam, ConvexPolyhedron& seen);

/// A quick test of the bounding sphere: why the view does not show the light, or Verdict::Drawn if the sphere does not
/// decide. Costs a tenth of lightVolume(). `sides` are viewSides(view, 1).
Verdict hiddenBySphere(const Light& light, const View& view, const LightPose& pose, std::span<const glm::dvec4> sides);

/// Left, right, top and bottom of the clip volume |x| <= width * w, |y| <= width * w.
InlineVector<glm::dvec4, 4> viewSides(const View& view, double width);

/// Metres along the light's axis of a point in view space.
inline double axisOf(const LightPose& pose, const glm::dvec3& point) {
    return axisOf(glm::dvec3(pose.lightFromView * glm::dvec4(point, 1.0)));
}

}  // namespace tyndall

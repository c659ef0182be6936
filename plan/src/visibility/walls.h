// Where blockers end a light's volume: the floor that a beam ends on, the corner of a room.
//
// Take the planes of some blockers. What the lamp sees of them without crossing another bounds a convex part of
// the pyramid. Where the blockers' triangles cover all of that part's faces on their planes, every ray of the lamp
// that leaves it is blocked: behind them is umbra, and neither slices nor a shadow map are called for.
#pragma once

#include <tyndall/light.h>
#include <tyndall/surroundings.h>
#include <tyndall/view.h>

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "geometry/inline_vector.h"
#include "geometry/slice_polygon.h"
#include "visibility/view_pose.h"

namespace tyndall {

/// A blocker's plane and place, the same for every light.
struct BlockerBounds {
    glm::dvec4 plane{0.0};  ///< world space, unit normal; zero where it has no area
    glm::dvec3 centre{0.0};
    double radius = 0.0;  ///< metres, of a sphere around it
    double area = 0.0;    ///< square metres
};

BlockerBounds boundsOf(const Blocker& blocker);

inline constexpr std::size_t mostWalls = 4;

/// Metres within which a surface counts as the wall itself, for a wall that lies `distance` metres from the lamp.
inline double wallMargin(double distance) {
    return 1e-3 + 1e-4 * distance;
}

/// Working memory.
struct WallScratch {
    std::vector<SlicePolygon> uncovered, left;
};

/// Planes of view space, unit normals, that keep the side where the light comes. Empty unless the blockers' triangles
/// cover all of the pyramid between them. Only blockers with the lamp and all of the picture's near plane on one side
/// count: from the other side the eye would see how a shadow map frays at them. They lie wallMargin() behind the
/// triangles, so that no slice ends before the surface does. A wall so steep to the light that a shadow map of
/// `mapSize` texels knows it by mapErrorAt() over 1/200 of its distance only is none. `bounds` has one entry for each
/// blocker.
InlineVector<glm::dvec4, mostWalls> wallsOf(const Light& light, const View& view, const LightPose& pose,
                                            std::span<const Blocker> blockers, std::span<const BlockerBounds> bounds,
                                            std::uint32_t mapSize, WallScratch& scratch);

/// Metres along the light's axis by which a shadow map, which knows surfaces at its texels' centres alone, holds these
/// walls to be too near to the lamp. With less of a bias they would throw shadows on the air before them. `axisLit`:
/// how far it is to the farthest point before them.
double mapErrorAt(std::span<const glm::dvec4> walls, const Light& light, const LightPose& pose, double axisLit,
                  std::uint32_t mapSize);

}  // namespace tyndall

// The walls that end a light's volume, for instance a floor or the corner of a room.
//
// The planes of some blockers bound a convex part of the light's volume: the part on the lamp's side of all of them.
// That part has faces on the blockers' planes. If the blockers' triangles cover all of these faces, they block every
// ray of the lamp that leaves the part: the air behind them is umbra and needs no slices and no shadow map.
#pragma once

#include <tyndall/blocker_set.h>
#include <tyndall/light.h>
#include <tyndall/view.h>

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "geometry/inline_vector.h"
#include "geometry/slice_polygon.h"
#include "visibility/view_pose.h"

namespace tyndall {

inline constexpr std::size_t maxWalls = 4;

/// Metres within which a surface counts as the wall itself, for a wall that lies `distance` metres from the lamp.
inline double wallMargin(double distance) {
    return 1e-3 + 1e-4 * distance;
}

/// Working memory.
struct WallScratch {
    std::vector<SlicePolygon> uncovered, left;
};

/// Planes of view space, unit normals, that keep the side of the lamp. Empty unless the blockers' triangles cover the
/// light's whole volume together. A blocker counts only if the lamp and all of the picture's near plane lie on the same
/// side of it: from the other side the eye would see the ragged edge of the shadow map. The planes lie wallMargin()
/// behind the triangles, so that every slice extends to the surface. A blocker is too steep to be a wall where
/// mapErrorAt() is more than 1/200 of its distance for a shadow map of `mapSize` texels a side.
InlineVector<glm::dvec4, maxWalls> wallsOf(const Light& light, const View& view, const LightPose& pose,
                                           const BlockerSet& blockers, std::uint32_t mapSize, WallScratch& scratch);

/// Metres along the light's axis by which a shadow map shows these walls too near to the lamp: it samples surfaces only
/// at the centres of its texels. With a smaller bias the walls would shadow the air before them. `axisLit`: metres to
/// the farthest point before them.
double mapErrorAt(std::span<const glm::dvec4> walls, const Light& light, const LightPose& pose, double axisLit,
                  std::uint32_t mapSize);

}  // namespace tyndall

// The large flat parts of a scene, prepared for planning: floors, walls, backdrops.
//
// A blocker stops all light that meets it. If blockers together cover a light's whole volume, all its light ends there:
// plan() ends the volume at them and draws no slices and no shadows of the air behind.
//
//   auto blockers = BlockerSet::fromMeshes(meshes, instances);     // once; those that do not move are enough
//   plan(lights, view, options, {.blockers = &*blockers});         // as often as wanted
#pragma once

#include <tyndall/meshes.h>
#include <tyndall/result.h>

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace tyndall {

/// Triangles of one plane, in metres of world space, of things that are drawn into the picture and into the shadow map.
struct Blocker {
    std::vector<std::array<glm::dvec3, 3>> triangles;  ///< within half a millimetre of one plane, either winding
};

/// A blocker's plane and place, the same for every light.
struct BlockerBounds {
    glm::dvec4 plane{0.0};   ///< world space, unit normal: that of the largest triangle; zero without any area
    glm::dvec3 centre{0.0};  ///< world space: a corner of the largest triangle
    double radius = 0.0;     ///< metres: a sphere around `centre` that holds the blocker
    double area = 0.0;       ///< square metres: the sum of the triangles'
};

/// A set owns copies of its input. An empty set does not end any light's volume.
class BlockerSet {
public:
    BlockerSet() = default;

    /// Finds the triangles of all instances that lie in one plane, for the planes with the largest areas: at most 64,
    /// each of at least a thousandth of the largest one's area. Takes memory for all triangles of all instances while
    /// it works.
    ///
    /// Errors: see OccluderSet::fromMeshes().
    static Result<BlockerSet> fromMeshes(std::span<const MeshTriangles> meshes,
                                         std::span<const MeshInstance> instances);

    /// The caller's own blockers. Give only large ones: plan() tests each for every light with shadow.
    /// Errors: InvalidArgument where a corner is not finite, or more than half a millimetre off the plane of its
    /// blocker's largest triangle.
    static Result<BlockerSet> fromBlockers(std::vector<Blocker> blockers);

    /// For a set from fromMeshes(): finds all blockers again if an instance has moved, or if instances were added or
    /// removed. One plane can hold triangles of many instances, so the search cannot be limited to some. False if
    /// nothing has moved; that costs a comparison of matrices.
    ///
    /// Errors: see fromMeshes(). The set is then unchanged.
    Result<bool> update(std::span<const MeshTriangles> meshes, std::span<const MeshInstance> instances);

    std::span<const Blocker> blockers() const { return blockers_; }
    /// Bounds of each blocker.
    std::span<const BlockerBounds> bounds() const { return bounds_; }

private:
    std::vector<Blocker> blockers_;
    std::vector<BlockerBounds> bounds_;
    std::vector<MeshInstance> instances_;  ///< as they stood when the blockers were found
};

}  // namespace tyndall

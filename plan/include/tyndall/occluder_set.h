// All occluders of a scene, prepared for planning: boxes around their triangles, checked and bounded once.
//
//   auto occluders = OccluderSet::fromMeshes(meshes, instances);   // once
//   occluders->move(instance, worldFromMesh);                      // for each instance that moves
//   plan(lights, view, options, {.occluders = &*occluders});       // as often as wanted
//
// plan() leaves the shadow term out where no occluder can stand between a lamp and the air that is seen. The set must
// hold every occluder that throws a shadow: the shadow of a missing one may be left out.
#pragma once

#include <tyndall/meshes.h>
#include <tyndall/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace tyndall {

/// A box around something that throws shadows. It may be flat.
struct OccluderBox {
    glm::dmat4 worldFromBox{1.0};           ///< affine: it may scale, shear and mirror
    glm::dvec3 minimum{0.0}, maximum{0.0};  ///< in the box's space
    /// The triangles within the box, in its space. Empty: they may be anywhere within the box.
    std::span<const std::array<glm::vec3, 3>> triangles = {};
};

/// World space, metres.
struct BoundingSphere {
    glm::dvec3 centre{0.0};
    double radius = 0.0;
};

/// A set owns copies of its input. An empty set means that there are no occluders.
class OccluderSet {
public:
    OccluderSet() = default;

    /// Boxes that together hold all triangles of all instances. A mesh is divided into at most 64 boxes that follow its
    /// shape: a single box around a lamp post with its arm would hold the lamp's whole cone. Triangles and boxes of a
    /// mesh are kept once for all its instances.
    ///
    /// Errors: InvalidArgument where a number of indices is not a multiple of three, an index or an instance's mesh is
    /// out of range, a stride is less than 12, a triangle's corner is not finite, or a worldFromMesh is not affine.
    static Result<OccluderSet> fromMeshes(std::span<const MeshTriangles> meshes,
                                          std::span<const MeshInstance> instances);

    /// Boxes of the caller's own. Each is one instance: box i moves by move(i, worldFromBox).
    ///
    /// Errors: InvalidArgument where a worldFromBox is not affine, a corner is not finite, a minimum is over its
    /// maximum, or a triangle lies outside of its box.
    static Result<OccluderSet> fromBoxes(std::span<const OccluderBox> boxes);

    /// Moves one instance and bounds its boxes again; the others stay as they are. False if it is there already. Does
    /// not allocate.
    ///
    /// Errors: InvalidArgument where there is no such instance or the matrix is not affine. The set is then unchanged.
    Result<bool> move(std::size_t instance, const glm::dmat4& worldFromMesh);

    std::size_t instances() const { return instances_.size(); }
    /// Number of boxes, by instance and within an instance in the order of its mesh's boxes.
    std::size_t size() const { return spheres_.size(); }
    /// Its triangles point into the set.
    OccluderBox box(std::size_t index) const;
    /// One for each box. A sphere holds its box, with a margin for the rounding of positions in 32-bit floats.
    std::span<const BoundingSphere> spheres() const { return spheres_; }

private:
    /// A box in its mesh's space.
    struct MeshBox {
        glm::dvec3 minimum, maximum;
        std::size_t firstTriangle, triangles;
    };
    struct Instance {
        glm::dmat4 worldFromMesh;
        std::size_t firstBox;     ///< into boxes_
        std::size_t firstSphere;  ///< into spheres_
        std::size_t boxes;
    };

    void addInstance(const glm::dmat4& worldFromMesh, std::size_t firstBox, std::size_t boxes);
    void bound(const Instance& instance);

    std::vector<std::array<glm::vec3, 3>> triangles_;  ///< by box
    std::vector<MeshBox> boxes_;                       ///< by mesh
    std::vector<Instance> instances_;
    std::vector<std::size_t> instanceOf_;  ///< by sphere
    std::vector<BoundingSphere> spheres_;
};

}  // namespace tyndall

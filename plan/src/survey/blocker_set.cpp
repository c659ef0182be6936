#include <tyndall/blocker_set.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "check/plan_check.h"
#include "survey/find_blockers.h"
#include "survey/read_mesh.h"

namespace tyndall {
namespace {

const std::string blockerSetPlace = "blocker set";

/// Metres, as Blocker says.
constexpr double maxOffPlane = 5e-4;

Result<void> checkFinite(const Blocker& blocker, std::size_t index) {
    for (const std::array<glm::dvec3, 3>& triangle : blocker.triangles)
        for (const glm::dvec3& corner : triangle)
            if (!isFinite(corner))
                return broken(blockerSetPlace + ": blocker " + std::to_string(index) + " has a corner at " +
                              text(corner) + ": it must be finite; check what it was computed from");
    return {};
}

bool sameInstance(const MeshInstance& a, const MeshInstance& b) {
    return a.mesh == b.mesh && a.worldFromMesh == b.worldFromMesh;
}

BlockerBounds boundsOf(const Blocker& blocker) {
    BlockerBounds bounds;
    glm::dvec3 normal(0.0);
    double largest = 0.0;
    for (const std::array<glm::dvec3, 3>& t : blocker.triangles) {
        const glm::dvec3 cross = glm::cross(t[1] - t[0], t[2] - t[0]);
        const double twice = glm::length(cross);
        bounds.area += 0.5 * twice;
        if (twice > largest) {
            largest = twice;
            normal = cross / twice;
            bounds.centre = t[0];
        }
    }
    if (!(bounds.area > 0.0)) return bounds;
    bounds.plane = glm::dvec4(normal, -glm::dot(normal, bounds.centre));
    for (const std::array<glm::dvec3, 3>& t : blocker.triangles)
        for (const glm::dvec3& corner : t)
            bounds.radius = std::max(bounds.radius, glm::distance(bounds.centre, corner));
    return bounds;
}

Result<void> checkFlat(const Blocker& blocker, const BlockerBounds& bounds, std::size_t index) {
    for (const std::array<glm::dvec3, 3>& triangle : blocker.triangles)
        for (const glm::dvec3& corner : triangle) {
            // Relative to a point of the plane: far from the origin, its offset has lost its digits.
            const double off = std::fabs(glm::dot(glm::dvec3(bounds.plane), corner - bounds.centre));
            if (off > maxOffPlane)
                return broken(blockerSetPlace + ": blocker " + std::to_string(index) + " has a corner at " +
                              text(corner) + ", " + text(off) +
                              " m off the plane of its largest triangle: it must lie within 0.0005 m; divide the "
                              "blocker, one for each plane");
        }
    return {};
}

}  // namespace

Result<BlockerSet> BlockerSet::fromBlockers(std::vector<Blocker> blockers) {
    BlockerSet set;
    for (std::size_t i = 0; i < blockers.size(); ++i) {
        if (const Result<void> checked = checkFinite(blockers[i], i); !checked)
            return at(blockerSetPlace, checked.error());
        set.bounds_.push_back(boundsOf(blockers[i]));
        if (const Result<void> checked = checkFlat(blockers[i], set.bounds_[i], i); !checked)
            return at(blockerSetPlace, checked.error());
    }
    set.blockers_ = std::move(blockers);
    return set;
}

Result<BlockerSet> BlockerSet::fromMeshes(std::span<const MeshTriangles> meshes,
                                          std::span<const MeshInstance> instances) {
    if (const Result<void> checked = checkMeshes(blockerSetPlace, meshes, instances); !checked)
        return at(blockerSetPlace, checked.error());
    // Finite corners in mesh space can still be too far for doubles in world space.
    auto set = fromBlockers(findBlockers(meshes, instances));
    if (set) set->instances_.assign(instances.begin(), instances.end());
    return set;
}

Result<bool> BlockerSet::update(std::span<const MeshTriangles> meshes, std::span<const MeshInstance> instances) {
    if (std::ranges::equal(instances, instances_, sameInstance)) return false;
    Result<BlockerSet> found = fromMeshes(meshes, instances);
    if (!found) return at(blockerSetPlace, found.error());
    *this = std::move(*found);
    return true;
}

}  // namespace tyndall

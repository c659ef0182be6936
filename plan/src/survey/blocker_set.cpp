#include <tyndall/blocker_set.h>

#include <algorithm>
#include <string>

#include "check/plan_check.h"
#include "survey/find_blockers.h"
#include "survey/read_mesh.h"

namespace tyndall {
namespace {

const std::string place = "blocker set";

Result<void> checkBlocker(const Blocker& blocker, std::size_t index) {
    for (const std::array<glm::dvec3, 3>& triangle : blocker.triangles)
        for (const glm::dvec3& corner : triangle)
            if (!isFinite(corner))
                return broken(place + ": blocker " + std::to_string(index) + " has a corner at " + text(corner) +
                              ": it must be finite; check what it was computed from");
    return {};
}

Result<void> checkBlockers(std::span<const Blocker> blockers) {
    for (std::size_t i = 0; i < blockers.size(); ++i)
        if (const Result<void> checked = checkBlocker(blockers[i], i); !checked) return checked;
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

}  // namespace

BlockerSet::BlockerSet(std::vector<Blocker> blockers) : blockers_(std::move(blockers)) {
    for (const Blocker& blocker : blockers_) bounds_.push_back(boundsOf(blocker));
}

Result<BlockerSet> BlockerSet::fromBlockers(std::vector<Blocker> blockers) {
    if (const Result<void> checked = checkBlockers(blockers); !checked) return tl::unexpected(checked.error());
    return BlockerSet(std::move(blockers));
}

Result<BlockerSet> BlockerSet::fromMeshes(std::span<const MeshTriangles> meshes,
                                          std::span<const MeshInstance> instances) {
    if (const Result<void> checked = checkMeshes(place, meshes, instances); !checked)
        return tl::unexpected(checked.error());
    // Finite corners in mesh space can still be too far for doubles in world space.
    auto set = fromBlockers(findBlockers(meshes, instances));
    if (set) set->instances_.assign(instances.begin(), instances.end());
    return set;
}

Result<bool> BlockerSet::update(std::span<const MeshTriangles> meshes, std::span<const MeshInstance> instances) {
    if (std::ranges::equal(instances, instances_, sameInstance)) return false;
    Result<BlockerSet> found = fromMeshes(meshes, instances);
    if (!found) return tl::unexpected(found.error());
    *this = std::move(*found);
    return true;
}

}  // namespace tyndall

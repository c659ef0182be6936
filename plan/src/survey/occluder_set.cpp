#include <tyndall/occluder_set.h>

#include <algorithm>
#include <string>

#include "check/plan_check.h"
#include "survey/box_margin.h"
#include "survey/cluster_triangles.h"
#include "survey/read_mesh.h"

namespace tyndall {
namespace {

const std::string occluderSetPlace = "occluder set";

Result<void> checkBox(const OccluderBox& box, std::size_t index) {
    const auto name = [&] { return occluderSetPlace + ": box " + std::to_string(index); };
    if (!isAffine(box.worldFromBox)) return broken(notAffine(name(), "worldFromBox"));
    if (!isFinite(box.minimum) || !isFinite(box.maximum) || glm::any(glm::greaterThan(box.minimum, box.maximum)))
        return broken(name() + " has the corners " + text(box.minimum) + " and " + text(box.maximum) +
                      ": they must be finite, and minimum nowhere over maximum; leave out what has no surface");
    const glm::dvec3 margin = glm::dvec3(boxShare) * (box.maximum - box.minimum);
    for (const std::array<glm::vec3, 3>& triangle : box.triangles)
        for (const glm::dvec3 corner : {glm::dvec3(triangle[0]), glm::dvec3(triangle[1]), glm::dvec3(triangle[2])})
            if (!glm::all(glm::greaterThanEqual(corner, box.minimum - margin)) ||
                !glm::all(glm::lessThanEqual(corner, box.maximum + margin)))  // NaN is in no box
                return broken(name() + " has a triangle with a corner at " + text(corner) + ": it must lie between " +
                              text(box.minimum) + " and " + text(box.maximum) +
                              "; make the box as large as its triangles");
    return {};
}

BoundingSphere sphereAround(const glm::dmat4& worldFromBox, const glm::dvec3& minimum, const glm::dvec3& maximum) {
    BoundingSphere sphere;
    const glm::dvec3 middle = 0.5 * (minimum + maximum), half = 0.5 * (maximum - minimum);
    sphere.centre = glm::dvec3(worldFromBox * glm::dvec4(middle, 1.0));
    for (int corner = 0; corner < 4; ++corner) {  // opposite corners are as far
        const glm::dvec3 to((corner & 1) ? half.x : -half.x, (corner & 2) ? half.y : -half.y, half.z);
        sphere.radius = std::max(sphere.radius, glm::length(glm::dmat3(worldFromBox) * to));
    }
    sphere.radius = sphere.radius * (1.0 + 2.0 * boxShare) + boxMargin;
    return sphere;
}

}  // namespace

void OccluderSet::addInstance(const glm::dmat4& worldFromMesh, std::size_t firstBox, std::size_t boxes) {
    const Instance instance{worldFromMesh, firstBox, spheres_.size(), boxes};
    instanceOf_.insert(instanceOf_.end(), boxes, instances_.size());
    spheres_.resize(spheres_.size() + boxes);
    instances_.push_back(instance);
    bound(instance);
}

void OccluderSet::bound(const Instance& instance) {
    for (std::size_t i = 0; i < instance.boxes; ++i) {
        const MeshBox& box = boxes_[instance.firstBox + i];
        spheres_[instance.firstSphere + i] = sphereAround(instance.worldFromMesh, box.minimum, box.maximum);
    }
}

Result<OccluderSet> OccluderSet::fromMeshes(std::span<const MeshTriangles> meshes,
                                            std::span<const MeshInstance> instances) {
    if (const Result<void> checked = checkMeshes(occluderSetPlace, meshes, instances); !checked)
        return at(occluderSetPlace, checked.error());
    OccluderSet set;
    std::vector<std::size_t> firstBoxes{0};  // by mesh, and behind the last
    for (const MeshTriangles& mesh : meshes) {
        std::vector<std::array<glm::vec3, 3>> triangles = trianglesOf(mesh);
        for (const TriangleCluster& cluster : clusterTriangles(triangles)) {
            set.boxes_.push_back({cluster.minimum, cluster.maximum, set.triangles_.size(), cluster.triangles.size()});
            set.triangles_.insert(set.triangles_.end(), cluster.triangles.begin(), cluster.triangles.end());
        }
        firstBoxes.push_back(set.boxes_.size());
    }
    for (const MeshInstance& instance : instances) {
        const std::size_t first = firstBoxes[instance.mesh];
        set.addInstance(instance.worldFromMesh, first, firstBoxes[instance.mesh + 1] - first);
    }
    return set;
}

Result<OccluderSet> OccluderSet::fromBoxes(std::span<const OccluderBox> boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (const Result<void> checked = checkBox(boxes[i], i); !checked) return at(occluderSetPlace, checked.error());
    OccluderSet set;
    for (const OccluderBox& box : boxes) {
        set.boxes_.push_back({box.minimum, box.maximum, set.triangles_.size(), box.triangles.size()});
        set.triangles_.insert(set.triangles_.end(), box.triangles.begin(), box.triangles.end());
        set.addInstance(box.worldFromBox, set.boxes_.size() - 1, 1);
    }
    return set;
}

Result<bool> OccluderSet::move(std::size_t instance, const glm::dmat4& worldFromMesh) {
    if (instance >= instances_.size())
        return broken(occluderSetPlace + ": instance " + std::to_string(instance) + " of " +
                      std::to_string(instances_.size()) +
                      " is to move: it must be less than their number; make the set anew where instances are added");
    if (instances_[instance].worldFromMesh == worldFromMesh) return false;
    if (!isAffine(worldFromMesh))
        return broken(notAffine(occluderSetPlace + ": instance " + std::to_string(instance), "worldFromMesh"));
    instances_[instance].worldFromMesh = worldFromMesh;
    bound(instances_[instance]);
    return true;
}

OccluderBox OccluderSet::box(std::size_t index) const {
    const Instance& instance = instances_[instanceOf_[index]];
    const MeshBox& box = boxes_[instance.firstBox + index - instance.firstSphere];
    return {instance.worldFromMesh, box.minimum, box.maximum,
            std::span(triangles_).subspan(box.firstTriangle, box.triangles)};
}

}  // namespace tyndall

#include "blockers.h"

#include <algorithm>

namespace tyndall::app {
namespace {

constexpr std::size_t most = 64;
constexpr double leastShare = 1e-3;
/// Metres that a corner may lie off its blocker's plane; Blocker grants half a millimetre.
constexpr double offPlane = 4e-4;

struct Flat {
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 normal{0.0};
    double area = 0.0;
};

std::vector<Flat> triangles(const Scene& scene) {
    std::vector<Flat> all;
    for (const MeshInstance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            Flat flat;
            for (std::size_t k = 0; k < 3; ++k)
                flat.corners[k] = glm::dvec3(instance.worldFromMesh *
                                             glm::dvec4(glm::dvec3(mesh.vertices[mesh.indices[i + k]].position), 1.0));
            const glm::dvec3 cross = glm::cross(flat.corners[1] - flat.corners[0], flat.corners[2] - flat.corners[0]);
            const double twice = glm::length(cross);
            if (!(twice > 0.0)) continue;
            flat.normal = cross / twice;
            flat.area = 0.5 * twice;
            all.push_back(flat);
        }
    }
    return all;
}

/// The plane of the largest of its triangles, which come first.
struct Plane {
    glm::dvec3 point, normal;
    double area = 0.0;
    Blocker blocker;

    bool holds(const Flat& flat) const {
        return std::all_of(flat.corners.begin(), flat.corners.end(), [&](const glm::dvec3& corner) {
            return std::abs(glm::dot(normal, corner - point)) <= offPlane;
        });
    }
};

}  // namespace

std::vector<Blocker> findBlockers(const Scene& scene) {
    std::vector<Flat> flats = triangles(scene);
    std::stable_sort(flats.begin(), flats.end(), [](const Flat& a, const Flat& b) { return a.area > b.area; });
    // Planes are opened by the largest triangles alone: what is finer than a few hundred planes is no wall.
    constexpr std::size_t mostOpened = 4 * most;
    std::vector<Plane> planes;
    for (const Flat& flat : flats) {
        auto plane = std::find_if(planes.begin(), planes.end(), [&](const Plane& p) { return p.holds(flat); });
        if (plane == planes.end()) {
            if (planes.size() == mostOpened) continue;
            planes.push_back({flat.corners[0], flat.normal, 0.0, {}});
            plane = planes.end() - 1;
        }
        plane->area += flat.area;
        plane->blocker.triangles.push_back(flat.corners);
    }
    std::stable_sort(planes.begin(), planes.end(), [](const Plane& a, const Plane& b) { return a.area > b.area; });
    std::vector<Blocker> blockers;
    for (Plane& plane : planes)
        if (blockers.size() < most && plane.area >= leastShare * planes.front().area)
            blockers.push_back(std::move(plane.blocker));
    return blockers;
}

}  // namespace tyndall::app

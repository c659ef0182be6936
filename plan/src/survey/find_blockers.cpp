#include "survey/find_blockers.h"

#include <algorithm>
#include <cmath>

#include "survey/read_mesh.h"

namespace tyndall {
namespace {

constexpr std::size_t maxBlockers = 64;
/// Of the largest blocker's area.
constexpr double minShare = 1e-3;
/// Finer planes than these hundreds are no walls: the largest triangles alone open planes.
constexpr std::size_t maxPlanes = 4 * maxBlockers;
/// Metres that a corner may lie off its blocker's plane; Blocker grants half a millimetre.
constexpr double offPlane = 4e-4;

struct Flat {
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 normal{0.0};
    double area = 0.0;
};

std::vector<Flat> flatsOf(std::span<const MeshTriangles> meshes, std::span<const MeshInstance> instances) {
    std::vector<Flat> all;
    for (const MeshInstance& instance : instances)
        for (const std::array<glm::vec3, 3>& triangle : trianglesOf(meshes[instance.mesh])) {
            Flat flat;
            for (std::size_t k = 0; k < 3; ++k)
                flat.corners[k] = glm::dvec3(instance.worldFromMesh * glm::dvec4(glm::dvec3(triangle[k]), 1.0));
            const glm::dvec3 cross = glm::cross(flat.corners[1] - flat.corners[0], flat.corners[2] - flat.corners[0]);
            const double twice = glm::length(cross);
            if (!(twice > 0.0)) continue;
            flat.normal = cross / twice;
            flat.area = 0.5 * twice;
            all.push_back(flat);
        }
    return all;
}

/// The plane of the largest of its triangles, which is the first.
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

std::vector<Blocker> findBlockers(std::span<const MeshTriangles> meshes, std::span<const MeshInstance> instances) {
    std::vector<Flat> flats = flatsOf(meshes, instances);
    std::stable_sort(flats.begin(), flats.end(), [](const Flat& a, const Flat& b) { return a.area > b.area; });
    std::vector<Plane> planes;
    for (const Flat& flat : flats) {
        auto plane = std::find_if(planes.begin(), planes.end(), [&](const Plane& p) { return p.holds(flat); });
        if (plane == planes.end()) {
            if (planes.size() == maxPlanes) continue;
            planes.push_back({flat.corners[0], flat.normal, 0.0, {}});
            plane = planes.end() - 1;
        }
        plane->area += flat.area;
        plane->blocker.triangles.push_back(flat.corners);
    }
    std::stable_sort(planes.begin(), planes.end(), [](const Plane& a, const Plane& b) { return a.area > b.area; });
    std::vector<Blocker> blockers;
    for (Plane& plane : planes)
        if (blockers.size() < maxBlockers && plane.area >= minShare * planes.front().area)
            blockers.push_back(std::move(plane.blocker));
    return blockers;
}

}  // namespace tyndall

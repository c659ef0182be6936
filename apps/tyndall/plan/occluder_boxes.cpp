#include "occluder_boxes.h"

#include <algorithm>
#include <span>

namespace tyndall::app {
namespace {

/// Of a mesh. plan() looks at each for every light that is seen: a few nanoseconds where it is far from the light.
constexpr std::size_t mostBoxes = 64;
/// Triangles of a box that is not worth halving.
constexpr std::size_t fewTriangles = 8;

struct Cluster {
    std::span<std::array<glm::dvec3, 3>> triangles;
    Bounds box;
};

Cluster clusterOf(std::span<std::array<glm::dvec3, 3>> triangles) {
    Cluster cluster{triangles, {}};
    for (const auto& triangle : triangles)
        for (const glm::dvec3& corner : triangle) {
            cluster.box.minimum = glm::min(cluster.box.minimum, corner);
            cluster.box.maximum = glm::max(cluster.box.maximum, corner);
        }
    return cluster;
}

double surface(const Bounds& box) {
    const glm::dvec3 e = box.maximum - box.minimum;
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

/// Halves at the middle of the longest side of the triangles' centres.
std::pair<Cluster, Cluster> halved(const Cluster& whole) {
    const auto middle = [](const std::array<glm::dvec3, 3>& t) { return (t[0] + t[1] + t[2]) / 3.0; };
    Bounds centres;
    for (const auto& triangle : whole.triangles) {
        centres.minimum = glm::min(centres.minimum, middle(triangle));
        centres.maximum = glm::max(centres.maximum, middle(triangle));
    }
    const glm::dvec3 extent = centres.maximum - centres.minimum;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::size_t half = whole.triangles.size() / 2;
    std::nth_element(whole.triangles.begin(), whole.triangles.begin() + static_cast<std::ptrdiff_t>(half),
                     whole.triangles.end(),
                     [&](const auto& a, const auto& b) { return middle(a)[axis] < middle(b)[axis]; });
    return {clusterOf(whole.triangles.first(half)), clusterOf(whole.triangles.subspan(half))};
}

std::vector<Bounds> boxesOf(const Mesh& mesh) {
    std::vector<std::array<glm::dvec3, 3>> triangles;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        triangles.push_back({glm::dvec3(mesh.vertices[mesh.indices[i]].position),
                             glm::dvec3(mesh.vertices[mesh.indices[i + 1]].position),
                             glm::dvec3(mesh.vertices[mesh.indices[i + 2]].position)});
    if (triangles.empty()) return {};
    std::vector<Cluster> open{clusterOf(triangles)};
    std::vector<Bounds> boxes;
    const auto smaller = [](const Cluster& a, const Cluster& b) { return surface(a.box) < surface(b.box); };
    while (!open.empty()) {  // the largest first
        std::pop_heap(open.begin(), open.end(), smaller);
        const Cluster cluster = open.back();
        open.pop_back();
        if (cluster.triangles.size() <= fewTriangles || boxes.size() + open.size() + 1 >= mostBoxes) {
            boxes.push_back(cluster.box);
            continue;
        }
        const auto [first, second] = halved(cluster);
        for (const Cluster& half : {first, second}) {
            open.push_back(half);
            std::push_heap(open.begin(), open.end(), smaller);
        }
    }
    return boxes;
}

}  // namespace

std::vector<OccluderBox> occluderBoxes(const Scene& scene) {
    std::vector<std::vector<Bounds>> byMesh;
    for (const Mesh& mesh : scene.meshes) byMesh.push_back(boxesOf(mesh));
    std::vector<OccluderBox> all;
    for (const MeshInstance& instance : scene.instances)
        for (const Bounds& box : byMesh[instance.mesh])
            all.push_back({instance.worldFromMesh, box.minimum, box.maximum});
    return all;
}

}  // namespace tyndall::app

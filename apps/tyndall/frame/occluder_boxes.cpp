#include "occluder_boxes.h"

#include <algorithm>
#include <span>

namespace tyndall::app {
namespace {

/// Of a mesh. plan() looks at each for every light that is seen: a few nanoseconds where it is far from the light.
constexpr std::size_t mostBoxes = 64;
/// Triangles of a box that is not worth halving.
constexpr std::size_t fewTriangles = 16;

struct Cluster {
    std::span<std::array<glm::vec3, 3>> triangles;
    Bounds box;
};

Cluster clusterOf(std::span<std::array<glm::vec3, 3>> triangles) {
    Cluster cluster{triangles, {}};
    for (const auto& triangle : triangles)
        for (const glm::vec3& corner : triangle) {
            cluster.box.minimum = glm::min(cluster.box.minimum, glm::dvec3(corner));
            cluster.box.maximum = glm::max(cluster.box.maximum, glm::dvec3(corner));
        }
    return cluster;
}

double surface(const Bounds& box) {
    const glm::dvec3 e = box.maximum - box.minimum;
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

/// Halves at the middle of the longest side of the triangles' centres.
std::pair<Cluster, Cluster> halved(const Cluster& whole) {
    const auto middle = [](const std::array<glm::vec3, 3>& t) { return glm::dvec3(t[0] + t[1] + t[2]) / 3.0; };
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

std::vector<std::array<glm::vec3, 3>> trianglesOf(const Mesh& mesh) {
    std::vector<std::array<glm::vec3, 3>> triangles;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        triangles.push_back({mesh.vertices[mesh.indices[i]].position, mesh.vertices[mesh.indices[i + 1]].position,
                             mesh.vertices[mesh.indices[i + 2]].position});
    return triangles;
}

/// Orders the triangles by cluster.
std::vector<Cluster> clustersOf(std::span<std::array<glm::vec3, 3>> triangles) {
    if (triangles.empty()) return {};
    std::vector<Cluster> open{clusterOf(triangles)}, done;
    const auto smaller = [](const Cluster& a, const Cluster& b) { return surface(a.box) < surface(b.box); };
    while (!open.empty()) {  // the largest first
        std::pop_heap(open.begin(), open.end(), smaller);
        const Cluster cluster = open.back();
        open.pop_back();
        if (cluster.triangles.size() <= fewTriangles || done.size() + open.size() + 1 >= mostBoxes) {
            done.push_back(cluster);
            continue;
        }
        const auto [first, second] = halved(cluster);
        for (const Cluster& half : {first, second}) {
            open.push_back(half);
            std::push_heap(open.begin(), open.end(), smaller);
        }
    }
    return done;
}

}  // namespace

OccluderBoxes occluderBoxes(const Scene& scene) {
    OccluderBoxes found;
    std::vector<std::vector<Cluster>> clusters;
    for (const Mesh& mesh : scene.meshes)
        clusters.push_back(clustersOf(found.triangles.emplace_back(trianglesOf(mesh))));
    for (std::size_t i = 0; i < scene.instances.size(); ++i)
        for (const Cluster& cluster : clusters[scene.instances[i].mesh]) {
            found.boxes.push_back(
                {scene.instances[i].worldFromMesh, cluster.box.minimum, cluster.box.maximum, cluster.triangles});
            found.instances.push_back(i);
        }
    return found;
}

bool moveBoxes(OccluderBoxes& occluders, const Scene& scene) {
    bool moved = false;
    for (std::size_t i = 0; i < occluders.boxes.size(); ++i) {
        const glm::dmat4& now = scene.instances[occluders.instances[i]].worldFromMesh;
        moved = moved || occluders.boxes[i].worldFromBox != now;
        occluders.boxes[i].worldFromBox = now;
    }
    return moved;
}

}  // namespace tyndall::app

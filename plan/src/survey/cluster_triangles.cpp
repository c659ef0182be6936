#include "survey/cluster_triangles.h"

#include <algorithm>
#include <limits>

namespace tyndall {
namespace {

/// Boxes of a mesh. plan() looks at each for every light that is seen: a few nanoseconds where it is far from the
/// light.
constexpr std::size_t maxBoxes = 64;
/// A box with no more triangles than this is not worth halving.
constexpr std::size_t fewTriangles = 16;

constexpr double unbounded = std::numeric_limits<double>::infinity();

TriangleCluster clusterOf(std::span<std::array<glm::vec3, 3>> triangles) {
    TriangleCluster cluster{triangles, glm::dvec3(unbounded), glm::dvec3(-unbounded)};
    for (const auto& triangle : triangles)
        for (const glm::vec3& corner : triangle) {
            cluster.minimum = glm::min(cluster.minimum, glm::dvec3(corner));
            cluster.maximum = glm::max(cluster.maximum, glm::dvec3(corner));
        }
    return cluster;
}

double surface(const TriangleCluster& cluster) {
    const glm::dvec3 e = cluster.maximum - cluster.minimum;
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

/// Halves at the median along the longest side of the triangles' centres.
std::pair<TriangleCluster, TriangleCluster> halved(const TriangleCluster& whole) {
    const auto middle = [](const std::array<glm::vec3, 3>& t) { return glm::dvec3(t[0] + t[1] + t[2]) / 3.0; };
    glm::dvec3 min(unbounded), max(-unbounded);
    for (const auto& triangle : whole.triangles) {
        min = glm::min(min, middle(triangle));
        max = glm::max(max, middle(triangle));
    }
    const glm::dvec3 extent = max - min;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::size_t half = whole.triangles.size() / 2;
    std::nth_element(whole.triangles.begin(), whole.triangles.begin() + static_cast<std::ptrdiff_t>(half),
                     whole.triangles.end(),
                     [&](const auto& a, const auto& b) { return middle(a)[axis] < middle(b)[axis]; });
    return {clusterOf(whole.triangles.first(half)), clusterOf(whole.triangles.subspan(half))};
}

}  // namespace

std::vector<TriangleCluster> clusterTriangles(std::span<std::array<glm::vec3, 3>> triangles) {
    if (triangles.empty()) return {};
    std::vector<TriangleCluster> open{clusterOf(triangles)}, done;
    const auto smaller = [](const TriangleCluster& a, const TriangleCluster& b) { return surface(a) < surface(b); };
    while (!open.empty()) {  // the largest first
        std::pop_heap(open.begin(), open.end(), smaller);
        const TriangleCluster cluster = open.back();
        open.pop_back();
        if (cluster.triangles.size() <= fewTriangles || done.size() + open.size() + 1 >= maxBoxes) {
            done.push_back(cluster);
            continue;
        }
        const auto [first, second] = halved(cluster);
        for (const TriangleCluster& half : {first, second}) {
            open.push_back(half);
            std::push_heap(open.begin(), open.end(), smaller);
        }
    }
    return done;
}

}  // namespace tyndall

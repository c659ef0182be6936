#include "triangle_tree.h"

#include <algorithm>
#include <limits>

namespace tyndall::study {
namespace {

constexpr std::uint32_t leafSize = 4;

glm::dvec3 centre(const Corners& t) {
    return (t[0] + t[1] + t[2]) / 3.0;
}

// The box's corner farthest along the normal decides.
bool outside(const glm::dvec3& minimum, const glm::dvec3& maximum, const HalfSpace& half) {
    const glm::dvec3 farthest(half.normal.x > 0.0 ? maximum.x : minimum.x, half.normal.y > 0.0 ? maximum.y : minimum.y,
                              half.normal.z > 0.0 ? maximum.z : minimum.z);
    return glm::dot(half.normal, farthest) + half.offset < 0.0;
}

}  // namespace

TriangleTree::TriangleTree(std::vector<Corners> triangles) : triangles_(std::move(triangles)) {
    nodes_.reserve(triangles_.size());
    if (!triangles_.empty()) build(0, static_cast<std::uint32_t>(triangles_.size()));
}

// Halves at the median of the longest axis: the tree is balanced, so its depth is bounded.
void TriangleTree::build(std::uint32_t first, std::uint32_t count) {
    Node node{glm::dvec3(std::numeric_limits<double>::infinity()), glm::dvec3(-std::numeric_limits<double>::infinity()),
              first, count, 0};
    for (std::uint32_t i = first; i < first + count; ++i)
        for (const glm::dvec3& p : triangles_[i]) {
            node.minimum = glm::min(node.minimum, p);
            node.maximum = glm::max(node.maximum, p);
        }
    const std::size_t index = nodes_.size();
    nodes_.push_back(node);
    if (count <= leafSize) return;

    const glm::dvec3 extent = node.maximum - node.minimum;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::uint32_t half = count / 2;
    std::nth_element(triangles_.begin() + first, triangles_.begin() + first + half, triangles_.begin() + first + count,
                     [axis](const Corners& a, const Corners& b) { return centre(a)[axis] < centre(b)[axis]; });
    build(first, half);
    nodes_[index].count = 0;
    nodes_[index].right = static_cast<std::uint32_t>(nodes_.size());
    build(first + half, count - half);
}

void TriangleTree::find(std::span<const HalfSpace> region, std::vector<std::uint32_t>& found) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, 64> open;  // 2^32 triangles halve 32 times
    std::size_t count = 0;
    open[count++] = 0;
    while (count > 0) {
        const std::uint32_t index = open[--count];
        const Node& node = nodes_[index];
        if (std::any_of(region.begin(), region.end(),
                        [&](const HalfSpace& half) { return outside(node.minimum, node.maximum, half); }))
            continue;
        if (node.count > 0) {
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) found.push_back(i);
        } else {
            open[count++] = node.right;
            open[count++] = index + 1;
        }
    }
}

}  // namespace tyndall::study

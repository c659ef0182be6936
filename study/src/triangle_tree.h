// A bounding volume hierarchy that finds the triangles which may touch a convex region.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace tyndall::study {

using Corners = std::array<glm::dvec3, 3>;

/// Half spaces dot(normal, p) + offset >= 0 that bound a convex region.
struct HalfSpace {
    glm::dvec3 normal;
    double offset;
};

class TriangleTree {
public:
    TriangleTree() = default;
    explicit TriangleTree(std::vector<Corners> triangles);

    const std::vector<Corners>& triangles() const { return triangles_; }

    /// Adds the index of every triangle that touches the region, and of some others: it skips a leaf only if one of the
    /// half spaces excludes its whole box.
    void find(std::span<const HalfSpace> region, std::vector<std::uint32_t>& found) const;

private:
    struct Node {
        glm::dvec3 minimum, maximum;
        std::uint32_t first = 0, count = 0;  ///< triangles of a leaf
        std::uint32_t right = 0;             ///< second child; the first follows its parent
    };
    void build(std::uint32_t first, std::uint32_t count);

    std::vector<Corners> triangles_;
    std::vector<Node> nodes_;
};

}  // namespace tyndall::study

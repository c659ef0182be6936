// A mesh's triangles in boxes that follow its shape.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace tyndall {

struct TriangleCluster {
    std::span<std::array<glm::vec3, 3>> triangles;
    glm::dvec3 minimum, maximum;  ///< a box that holds them
};

/// At most 64 clusters that together hold every triangle once. Orders the triangles by cluster.
std::vector<TriangleCluster> clusterTriangles(std::span<std::array<glm::vec3, 3>> triangles);

}  // namespace tyndall

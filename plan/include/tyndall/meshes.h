// Triangles and instances of a scene as surveys read them: views of the caller's own memory, in any vertex layout.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace tyndall {

/// A triangle list. The first vertex's position is at `positions`, the next `stride` bytes farther, and so on.
struct MeshTriangles {
    const glm::vec3* positions = nullptr;    ///< metres, in mesh space
    std::size_t vertices = 0;                ///< number of positions
    std::size_t stride = sizeof(glm::vec3);  ///< bytes from one position to the next, 12 or more
    std::span<const std::uint32_t> indices;  ///< three a triangle, each less than `vertices`
};

struct MeshInstance {
    std::size_t mesh = 0;           ///< index into the meshes that are given with the instances
    glm::dmat4 worldFromMesh{1.0};  ///< affine: it may scale, shear and mirror
};

}  // namespace tyndall

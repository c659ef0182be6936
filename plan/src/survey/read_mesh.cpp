#include "survey/read_mesh.h"

#include <cstring>
#include <string>

#include "check/plan_check.h"

namespace tyndall {
namespace {

glm::vec3 positionOf(const MeshTriangles& mesh, std::uint32_t vertex) {
    glm::vec3 position;
    std::memcpy(&position, reinterpret_cast<const std::byte*>(mesh.positions) + vertex * mesh.stride, sizeof position);
    return position;
}

Result<void> checkMesh(const std::string& mesh, const MeshTriangles& triangles) {
    if (triangles.stride < sizeof(glm::vec3))
        return broken(mesh + " has a stride of " + std::to_string(triangles.stride) +
                      " bytes: it must be 12 or more; give the size of a vertex");
    if (triangles.indices.size() % 3 != 0)
        return broken(mesh + " has " + std::to_string(triangles.indices.size()) +
                      " indices: they must be a multiple of 3; give a triangle list");
    for (const std::uint32_t index : triangles.indices) {
        if (index >= triangles.vertices)
            return broken(mesh + " has the index " + std::to_string(index) + " with " +
                          std::to_string(triangles.vertices) +
                          " vertices: it must be less than their number; give all vertices that indices name");
        if (const glm::dvec3 position(positionOf(triangles, index)); !isFinite(position))
            return broken(mesh + " has a corner at " + text(position) +
                          ": it must be finite; check what it was computed from");
    }
    return {};
}

}  // namespace

bool isAffine(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        if (!isFinite(glm::dvec3(matrix[column])) || matrix[column].w != (column == 3 ? 1.0 : 0.0)) return false;
    return true;
}

std::string notAffine(const std::string& owner, std::string_view field) {
    return owner + " has a " + std::string(field) +
           " that is not affine: its numbers must be finite and its last row (0, 0, 0, 1); check what it was computed "
           "from";
}

Result<void> checkMeshes(std::string_view place, std::span<const MeshTriangles> meshes,
                         std::span<const MeshInstance> instances) {
    const auto name = [&](const char* what, std::size_t index) {
        return std::string(place) + ": " + what + " " + std::to_string(index);
    };
    for (std::size_t i = 0; i < meshes.size(); ++i)
        if (const Result<void> checked = checkMesh(name("mesh", i), meshes[i]); !checked) return checked;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (instances[i].mesh >= meshes.size())
            return broken(name("instance", i) + " is of mesh " + std::to_string(instances[i].mesh) + " of " +
                          std::to_string(meshes.size()) +
                          " meshes: it must be less than their number; give all meshes that instances name");
        if (!isAffine(instances[i].worldFromMesh)) return broken(notAffine(name("instance", i), "worldFromMesh"));
    }
    return {};
}

std::vector<std::array<glm::vec3, 3>> trianglesOf(const MeshTriangles& mesh) {
    std::vector<std::array<glm::vec3, 3>> triangles;
    triangles.reserve(mesh.indices.size() / 3);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        triangles.push_back({positionOf(mesh, mesh.indices[i]), positionOf(mesh, mesh.indices[i + 1]),
                             positionOf(mesh, mesh.indices[i + 2])});
    return triangles;
}

}  // namespace tyndall

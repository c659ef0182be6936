// Triangles of meshes as surveys are given them, checked and read.
#pragma once

#include <tyndall/meshes.h>
#include <tyndall/result.h>

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall {

/// `place` begins the messages: the name of what is being made.
///
/// Errors: InvalidArgument where a mesh or an instance breaks a rule of <tyndall/meshes.h> or has a corner that is not
/// finite.
Result<void> checkMeshes(std::string_view place, std::span<const MeshTriangles> meshes,
                         std::span<const MeshInstance> instances);

/// The mesh must have passed checkMeshes().
std::vector<std::array<glm::vec3, 3>> trianglesOf(const MeshTriangles& mesh);

/// Finite, with the last row (0, 0, 0, 1).
bool isAffine(const glm::dmat4& matrix);

/// What to say of a matrix that is not: `owner` names what it belongs to, `field` the matrix.
std::string notAffine(const std::string& owner, std::string_view field);

}  // namespace tyndall

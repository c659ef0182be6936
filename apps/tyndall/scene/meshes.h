// Surfaces from glTF: triangle lists with normals, texture coordinates and materials.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "document.h"
#include "scene.h"

namespace tyndall::app {

/// Gives the index in Scene::images of a glTF texture that holds colour.
using ColourTexture = std::function<Result<std::size_t>(int texture, const std::string& user)>;

/// The primitives of one glTF mesh. Points and lines are left out with a warning. Missing and zero
/// normals are computed from the triangles, smooth at shared vertices.
Result<std::vector<Mesh>> readMesh(const tinygltf::Model& model, std::size_t mesh, const ColourTexture& texture,
                                   std::vector<std::string>& warnings);

}  // namespace tyndall::app

// Cameras from glTF.
#pragma once

#include "document.h"
#include "scene.h"

namespace tyndall::app {

/// The camera of one node. `pose` is the node's world transform. Errors: an angle outside of 0 to 180 degrees,
/// planes out of order.
Result<Camera> readCamera(const tinygltf::Model& model, std::size_t node, const glm::dmat4& pose);

}  // namespace tyndall::app

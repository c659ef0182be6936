// World transforms of the nodes of a glTF scene at one time.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "document.h"

namespace tyndall::app {

/// World transforms of the nodes of the file's scene at `time` seconds, by node index; empty for nodes
/// outside the scene. All of the file's animations play, held at their first and last keys.
/// Errors: transforms or keys that are not finite, keys that decrease.
Result<std::vector<std::optional<glm::dmat4>>> worldPoses(const tinygltf::Model& model, double time);

/// Rotation and translation only: keeps the direction of -Z exactly and +Y as nearly as possible; removes scale and
/// mirroring. Errors: an axis of length 0.
Result<glm::dmat4> rigidPart(const glm::dmat4& pose, const std::string& place);

/// "node "Lamp"", or the index of a node without a name.
std::string nodeName(const tinygltf::Model& model, std::size_t node);

}  // namespace tyndall::app

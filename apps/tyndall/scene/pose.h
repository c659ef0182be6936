// Where every node of a glTF scene stands at one moment.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "document.h"

namespace tyndall::app {

/// World transforms of the nodes of the file's scene at `time` seconds, by node index; empty for nodes
/// that the scene does not hold. All of the file's animations play, held at their first and last keys.
/// Errors: transforms or keys that are not finite, keys that run backwards.
Result<std::vector<std::optional<glm::dmat4>>> worldPoses(const tinygltf::Model& model, double time);

/// Rotation and translation alone: the direction of -Z is kept exactly, +Y as near as it can be, scale and
/// mirroring go. Errors: an axis of no length.
Result<glm::dmat4> rigidPart(const glm::dmat4& pose, const std::string& place);

/// "node "Lamp"", or the index of a node without a name.
std::string nodeName(const tinygltf::Model& model, std::size_t node);

}  // namespace tyndall::app

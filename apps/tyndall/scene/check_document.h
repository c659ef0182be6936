// Checks that a glTF document is consistent, before its indices are used.
#pragma once

#include <kit/fail.h>

#include <cstddef>
#include <nlohmann/json.hpp>

namespace tyndall::app {

/// The first error: an index out of range, a view outside its buffer, an accessor outside its view, a node below
/// itself or below two parents, an invalid transform, a required extension that is not read. `binary` and
/// `binaryLength` describe the .glb's own chunk.
Result<void> checkDocument(const nlohmann::json& gltf, bool binary, std::size_t binaryLength);

}  // namespace tyndall::app

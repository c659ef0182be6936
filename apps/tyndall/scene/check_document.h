// Whether a glTF document holds together, before anything follows its indices.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include <kit/fail.h>

namespace tyndall::app {

/// The first thing wrong: an index that points at nothing, a view outside its buffer, an accessor outside
/// its view, a node below itself or below two parents, a transform that is none, a required extension that is
/// not read. `binary`
/// and `binaryLength` describe the .glb's own chunk.
Result<void> checkDocument(const nlohmann::json& gltf, bool binary, std::size_t binaryLength);

}  // namespace tyndall::app

// A glTF file, parsed and checked: every index is in range, every buffer view lies in its buffer. Later code
// need not check them again.
#pragma once

#include <kit/fail.h>
#include <tiny_gltf.h>

#include <nlohmann/json.hpp>
#include <string>

namespace tyndall::app {

struct Document {
    nlohmann::json json;    ///< as written, for extras and other parts that tinygltf leaves out
    tinygltf::Model model;  ///< images as keepEncoded() keeps them
    std::string warnings;   ///< tinygltf's own, usually empty
};

/// Reads `path`, .glb or .gltf by content, with the buffers and images it names. Images stay encoded: unused
/// textures are not decoded, and may be broken.
Result<Document> readDocument(const std::string& path);

}  // namespace tyndall::app

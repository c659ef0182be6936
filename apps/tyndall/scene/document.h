// A glTF file, parsed and checked: every index points at something, every buffer view lies in its
// buffer. What follows may look things up without asking again.
#pragma once

#include <tiny_gltf.h>

#include <nlohmann/json.hpp>
#include <string>

#include <kit/fail.h>

namespace tyndall::app {

struct Document {
    nlohmann::json json;    ///< as written, for extras and whatever tinygltf leaves out
    tinygltf::Model model;  ///< images as keepEncoded() keeps them
    std::string warnings;   ///< tinygltf's own, usually empty
};

/// Reads `path`, .glb or .gltf by content, with the buffers and images it names. Images stay encoded: a texture
/// that nothing draws costs no decoding, and may be broken.
Result<Document> readDocument(const std::string& path);

}  // namespace tyndall::app

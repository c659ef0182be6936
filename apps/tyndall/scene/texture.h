// glTF textures as linear images.
#pragma once

#include "document.h"
#include "scene.h"

namespace tyndall::app {

enum class Encoding {
    Srgb,    ///< colour, as glTF stores it; alpha is linear
    Linear,  ///< data: noise
};

/// The index of a glTF texture's image. Exporters give each material its own texture, and several textures one
/// image. `user` names the user in messages. Errors: an index out of range, a texture without image.
Result<std::size_t> imageOf(const tinygltf::Model& model, int texture, const std::string& user);

/// Decodes an image of the file. Errors: it is missing or damaged.
Result<Image> readImage(const tinygltf::Model& model, std::size_t source, Encoding encoding, const std::string& user);

/// The image's value at (u, v), bilinear, edges held.
glm::vec4 sampleClamped(const Image& image, double u, double v);

}  // namespace tyndall::app

// glTF textures as linear images.
#pragma once

#include "document.h"
#include "scene.h"

namespace tyndall::app {

enum class Encoding {
    Srgb,    ///< colour, as glTF stores it; alpha is linear
    Linear,  ///< data: noise
};

/// The image of a glTF texture. `user` names who asks. Errors: an index out of range, a texture without an
/// image that was decoded.
Outcome<Image> readTexture(const tinygltf::Model& model, int texture, Encoding encoding, const std::string& user);

/// The image's value at (u, v), bilinear, edges held.
glm::vec4 sampleClamped(const Image& image, double u, double v);

}  // namespace tyndall::app

// Spot lights from glTF, with their extras.tyndall.
#pragma once

#include <functional>
#include <optional>

#include "document.h"
#include "scene.h"

namespace tyndall::app {

/// A light as read; its glTF textures are not loaded yet.
struct ReadLight {
    SceneLight light;
    std::optional<int> cookieTexture, noiseTexture;
};

/// A spot light on `node`. `pose` is the node's world transform; `parent` the node above it, if any, whose
/// extras count if the light's own node has none (some exporters put lamps into a child to rotate them).
/// `bounds` gives the default far plane of a light without range. Errors: values that plan() would refuse.
Result<ReadLight> readSpotLight(const Document& document, std::size_t node, std::optional<std::size_t> parent,
                                const glm::dmat4& pose, const Bounds& bounds, std::vector<std::string>& warnings);

}  // namespace tyndall::app

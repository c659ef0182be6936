// Spot lights out of glTF, with what extras.tyndall says about them.
#pragma once

#include <functional>
#include <optional>

#include "document.h"
#include "scene.h"

namespace tyndall::app {

/// A light as read; the glTF textures that it names are still to be looked up.
struct ReadLight {
    SceneLight light;
    std::optional<int> cookieTexture, noiseTexture;
};

/// A spot light on `node`. `pose` is the node's in the world; `parent` the node above it, if any, whose
/// extras count where the light's own node has none (exporters that turn lamps put them into a child).
/// `bounds` gives the default far plane of a light without range. Errors: whatever plan() would refuse.
Result<ReadLight> readSpotLight(const Document& document, std::size_t node, std::optional<std::size_t> parent,
                                 const glm::dmat4& pose, const Bounds& bounds, std::vector<std::string>& warnings);

}  // namespace tyndall::app

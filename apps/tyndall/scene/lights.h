// Spot lights out of glTF, with what extras.tyndall says about them.
#pragma once

#include <functional>
#include <optional>

#include "document.h"
#include "scene.h"
#include "texture.h"

namespace tyndall::app {

/// A light as read, with its pictures still beside it.
struct ReadLight {
    SceneLight light;
    std::optional<Image> cookie;
    std::optional<int> noiseTexture;
};

/// A spot light on `node`. `pose` is the node's in the world; `parent` the node above it, if any, whose
/// extras count where the light's own node has none (exporters that turn lamps put them into a child).
/// `bounds` gives the default far plane of a light without range. Errors: whatever plan() would refuse, and
/// a texture index out of range.
Outcome<ReadLight> readSpotLight(const Document& document, std::size_t node, std::optional<std::size_t> parent,
                                 const glm::dmat4& pose, const Bounds& bounds, std::vector<std::string>& warnings);

}  // namespace tyndall::app

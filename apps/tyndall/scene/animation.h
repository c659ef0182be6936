// glTF animation channels, sampled.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>

#include "document.h"

namespace tyndall::app {

/// The animated transform of one node; parts that are not animated are absent.
struct AnimatedNode {
    std::optional<glm::dvec3> translation;
    std::optional<glm::dquat> rotation;
    std::optional<glm::dvec3> scale;
};

/// Every animated node of the file at `time` seconds. Interpolation as in glTF 2.0, appendix C.
Result<std::map<std::size_t, AnimatedNode>> sampleAnimations(const tinygltf::Model& model, double time);

}  // namespace tyndall::app

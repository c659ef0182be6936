// How a shadow map's points are found: what draws it and what asks for occluders must not disagree.
#pragma once

#include <tyndall/renderer.h>

#include <glm/matrix.hpp>

namespace tyndall {

// In double all the way: far from the origin, world coordinates in float would be off by millimetres.

inline glm::dmat4 shadowClipFromWorld(const Light& light) {
    return lightClipFromLight(light) * glm::inverse(light.worldFromLight);
}

inline glm::dmat4 shadowClipFromMesh(const glm::dmat4& clipFromWorld, const Occluder& occluder) {
    return clipFromWorld * occluder.worldFromMesh;
}

}  // namespace tyndall

// A plane (n, d) stands for the half space that keeps dot(n, p) + d >= 0.
#pragma once

#include <glm/glm.hpp>

namespace tyndall {

/// The same half space with a unit normal.
inline glm::dvec4 unitPlane(const glm::dvec4& plane) {
    return plane / glm::length(glm::dvec3(plane));
}

}  // namespace tyndall

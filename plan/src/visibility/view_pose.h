// Poses and planes as the eye sees them. Translations are subtracted before rotations are applied: this keeps plans
// accurate a thousand kilometres from the world's origin.
#pragma once

#include <glm/glm.hpp>

#include "geometry/plane.h"

namespace tyndall {

struct LightPose {
    glm::dmat4 viewFromLight;
    glm::dmat4 lightFromView;
};

/// Both matrices are affine with the last row (0, 0, 0, 1).
LightPose lightPose(const glm::dmat4& worldFromLight, const glm::dmat4& worldFromView);

/// A world-space plane that keeps dot(n, p) + d >= 0, in view space and with a unit normal.
glm::dvec4 viewPlane(const glm::dvec4& worldPlane, const glm::dmat4& worldFromView);

}  // namespace tyndall

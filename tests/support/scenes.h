// Set-ups for drawing the permutations: one lamp with everything that a technique may need, seen from easy and hard
// viewpoints.
#pragma once

#include <tyndall/terms.h>

#include <string>
#include <vector>

#include "oracle.h"

namespace tyndall::test {

struct NamedShot {
    std::string name;
    Shot shot;
};

/// A rigid frame at `position` that looks along `direction` (-Z), turned by `roll` radians about it.
glm::dmat4 lookAlong(glm::dvec3 position, glm::dvec3 direction, double roll = 0.0);

/// The lamp with cookie, shadow map and noise, from the side, 16 slices.
Shot sideView();

/// sideView() and its harder siblings: inside the volume, towards the lamp, oblique, with a surface, with
/// clip planes, orthographic, the published constants, odd numbers of slices.
std::vector<NamedShot> shots();

/// Drops the terms that a technique lacks.
Shot withTerms(Shot shot, TermSet terms);

/// The same scene under a rigid motion of the world.
Shot moved(Shot shot, const glm::dmat4& motion);

/// Stored scene depth of the plane through `point` with `normal` (world space), 0 if a ray misses it.
Texture planeDepth(const Shot& shot, glm::dvec3 point, glm::dvec3 normal);

}  // namespace tyndall::test

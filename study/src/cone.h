// The falloff of a cone along a ray.
#pragma once

#include <study/reference.h>

#include <vector>

#include "light_ray.h"

namespace tyndall::study {

/// What a cone leaves of the light where the direction from the lamp has this cosine to its axis, 0 to 1:
/// KHR_lights_punctual, "Inner and Outer Cone Angles".
double coneFalloff(const Cone& cone, double cosine);

/// Whether that direction is within full light, not on its edge: a ray may touch the edge and be dimmer all around.
bool inFullLight(const Cone& cone, double cosine);

/// Adds the places within `span` where the ray enters or leaves the dark, and full light.
void addCrossings(std::vector<double>& places, const Cone& cone, const LightRay& ray, Span span);

}  // namespace tyndall::study

// The falloff of a cone along a ray.
#pragma once

#include <study/reference.h>

#include <vector>

#include "light_ray.h"

namespace tyndall::study {

/// The cone's factor, 0 to 1, for a direction from the lamp with this cosine to its axis: KHR_lights_punctual, "Inner
/// and Outer Cone Angles".
double coneFalloff(const Cone& cone, double cosine);

/// Whether that direction is inside full light, not on its edge: a ray may touch the edge and be dimmer on both sides.
bool inFullLight(const Cone& cone, double cosine);

/// Adds the positions within `span` where the ray crosses the edge of the dark or of full light.
void addCrossings(std::vector<double>& places, const Cone& cone, const LightRay& ray, Span span);

}  // namespace tyndall::study

// The exact shadows that triangles throw through the air: the stretches of a ray from which the lamp is hidden.
//
// Ray and lamp span a plane. Every triangle cuts that plane in a straight piece, and the piece hides one stretch
// of the ray from the lamp. The rest of the ray is lit. Nothing is sampled, so thin occluders count, too.
#pragma once

#include <study/reference.h>
#include <tyndall/light.h>

#include <vector>

#include "light_ray.h"
#include "shadow.h"
#include "triangle_tree.h"

namespace tyndall::study {

/// The triangles that can throw a shadow within the light's pyramid, in light space.
TriangleTree occluders(const Light& light, const std::vector<Triangle>& triangles);

/// The stretches of `span` that see the lamp, in order, without overlap. `span` lies within the light's pyramid.
/// Triangles before the light's near plane throw no shadow.
void litSpans(std::vector<LitSpan>& lit, const TriangleTree& occluders, double nearPlane, const LightRay& ray,
              Span span);

/// Maximum error of the shadows' edges in metres, from rounding of the plane through ray and lamp.
double edgeError(const LightRay& ray, Span span);

}  // namespace tyndall::study

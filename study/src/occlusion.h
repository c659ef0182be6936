// The shadows that triangles throw through the air, exactly: where along a ray the lamp is hidden.
//
// Ray and lamp span a plane. Every triangle cuts that plane in a straight piece, and the piece hides one stretch
// of the ray from the lamp. What no stretch covers is lit. No sampling, so no occluder is too thin.
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

/// What of `span`, which lies within the light's pyramid, sees the lamp. What stands nearer to the lamp than its
/// near plane throws no shadow. In order, without overlap.
void litSpans(std::vector<LitSpan>& lit, const TriangleTree& occluders, double nearPlane, const LightRay& ray,
              Span span);

/// Metres by which the shadows' edges may be off: what doubles leave of the plane through ray and lamp.
double edgeError(const LightRay& ray, Span span);

}  // namespace tyndall::study

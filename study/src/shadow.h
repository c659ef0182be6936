// The stretches of a ray that the lamp lights, by a shadow map.
#pragma once

#include <array>
#include <vector>

#include "light_ray.h"
#include "texel_grid.h"

namespace tyndall::study {

/// A lit or partly lit stretch. It is in full light if all four corners are lit; otherwise it lies within one cell of
/// the shadow map, and its light is the weight of the lit corners.
struct LitSpan {
    Span span;
    std::array<bool, 4> corners{true, true, true, true};

    bool full() const { return corners[0] && corners[1] && corners[2] && corners[3]; }
};

/// A shadow map with its stored depths turned back into metres along the light's axis.
struct ShadowMap {
    Image stored;
    std::vector<double> maxLitAxis;  ///< by texel: points up to this distance along the axis are lit
};

/// `stored` reversed depth, as lightClipFromLight() projects it; `bias` metres.
ShadowMap shadowMap(const Light& light, Image stored, double bias);

/// The light that four texels let through: compared first, then filtered bilinearly. `path` is the map's. Neighbouring
/// stretches in full light are joined. In order, without overlap.
void litSpans(std::vector<LitSpan>& lit, const ShadowMap& map, const TexelPath& path, const LightRay& ray, Span span);

}  // namespace tyndall::study

// Which stretches of a ray the lamp reaches.
#pragma once

#include <array>
#include <vector>

#include "light_ray.h"
#include "texel_grid.h"

namespace tyndall::study {

/// A stretch that is not wholly dark. All four corners lit is full light; otherwise the stretch lies within one
/// cell of the shadow map, and the light that comes through is the weight of the lit corners.
struct LitSpan {
    Span span;
    std::array<bool, 4> corners{true, true, true, true};

    bool full() const { return corners[0] && corners[1] && corners[2] && corners[3]; }
};

/// A shadow map with its stored depths turned back into metres along the light's axis.
struct ShadowMap {
    Image stored;
    std::vector<double> reach;  ///< by texel: what lies at or before this axis distance is lit
};

/// `stored` reversed depth, as lightClipFromLight() projects it; `bias` metres.
ShadowMap shadowMap(const Light& light, Image stored, double bias);

/// Comparison first, bilinear filter after: the light that four texels let through. `path` is the map's.
/// Neighbouring stretches in full light are joined. In order, without overlap.
void litSpans(std::vector<LitSpan>& lit, const ShadowMap& map, const TexelPath& path, const LightRay& ray, Span span);

}  // namespace tyndall::study

// The light that one lamp's air sends along one ray.
#pragma once

#include <study/reference.h>

#include <vector>

#include "quadrature.h"
#include "shadow.h"
#include "texel_grid.h"

namespace tyndall::study {

/// The path of a ray through each of a light's textures.
struct TexturePaths {
    TexelPath cookie, noise1, noise2;
};

TexturePaths texturePaths(const ReferenceLight& light, const LightRay& ray, double time);

/// Integral over the lit spans of noise * cookie * shadow * phase * transmittance * (I / d^2 + ambient) ds, without the
/// light's colour and density, to the relative error `accuracy` in each channel. `shadow` is the shadow map's path.
Quadrature lightIntegral(const ReferenceLight& light, const LightRay& ray, const TexturePaths& paths,
                         const TexelPath& shadow, const ShadowMap& map, const std::vector<LitSpan>& lit,
                         double accuracy);

}  // namespace tyndall::study

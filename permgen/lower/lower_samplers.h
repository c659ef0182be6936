// The dimension of each sampler. D3D9's untyped `sampler` gets it from the texture functions that read it.
#pragma once

#include <map>
#include <vector>

#include "front/effect.h"
#include "lower/lowered.h"

namespace permgen {

struct SamplerDimensions {
    std::vector<ImageDimension> samplers;                ///< of ParsedEffect::samplers
    std::map<std::size_t, std::string> parameter_types;  ///< token of an untyped parameter's `sampler`, to its type
};

/// Follows samplers through calls of the effect's own functions. An unread sampler counts as 2D; reading one sampler
/// with two dimensions is an error.
SamplerDimensions infer_sampler_dimensions(const ParsedEffect& effect, const Sources& sources,
                                           Diagnostics& diagnostics);

/// "sampler2D"
std::string sampler_type(ImageDimension dimension);

}  // namespace permgen

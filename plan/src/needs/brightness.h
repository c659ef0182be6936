// The maximum brightness of a light.
#pragma once

#include <tyndall/light.h>

#include "slabs/slabs.h"
#include "visibility/seen_air.h"

namespace tyndall {

/// Upper bound of a pixel's radiance, in the light's strongest channel, with every term's factor 1. Holds for the
/// integral and for the sum of the slices, see maxAttenuationAlong().
double brightestWithoutTerms(const Light& light, const SeenAir& air, const Slabs& slabs);

}  // namespace tyndall

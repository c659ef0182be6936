// How bright a light can get, at most.
#pragma once

#include <tyndall/light.h>

#include "visibility/seen_air.h"
#include "slabs/slabs.h"

namespace tyndall {

/// Radiance that no pixel exceeds, in the light's strongest channel, with noise, cookie and shadow of 1. Holds for
/// the integral and for the sum of the slices alike, see maxAttenuationAlong().
double brightestWithoutTerms(const Light& light, const SeenAir& air, const Slabs& slabs);

}  // namespace tyndall

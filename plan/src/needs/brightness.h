// How bright a light can get, at most.
#pragma once

#include <tyndall/light.h>

#include "slabs/slabs.h"
#include "visibility/seen_air.h"

namespace tyndall {

/// Radiance that no pixel exceeds, in the light's strongest channel, with every term's factor 1. Holds for
/// the integral and for the sum of the slices alike.
///
/// Along a ray, d >= the least distance D. The integral of dt / d^2 over a length L is at most L / D^2, and at most
/// 4 / D: where the ray passes the lamp at h >= D it is pi / h; where h < D, it is within D of the lamp over at most
/// 2 sqrt(D^2 - h^2), where dt / D^2 bounds it, and each of the two ends outside adds at most 1 / D. A sum over slabs
/// of a function with one peak exceeds its integral by at most the thickest slab times the peak.
double brightestWithoutTerms(const Light& light, const SeenAir& air, const Slabs& slabs);

}  // namespace tyndall

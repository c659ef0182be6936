// How much light arrives from a lamp: I / d^2 + ambient at d metres.
#pragma once

#include <tyndall/light.h>

namespace tyndall {

/// The largest attenuation in the light's volume: at its near plane.
double maxAttenuation(const Light& light);

/// Upper bound of the sum of attenuation times length along a ray that runs through at most `maxLength` metres of the
/// light's air, all of it at least `minAxis` metres along the axis. Holds for the integral, and for a sum over slabs
/// that are at most `maxSlab` metres long on that ray.
///
/// Along a ray, d is at least the minimum distance D. The integral of dt / d^2 over a length L is at most L / D^2, and
/// at most 4 / D: where the ray passes the lamp at h >= D it is pi / h; where h < D, it is within D of the lamp over at
/// most 2 sqrt(D^2 - h^2), where dt / D^2 bounds it, and each of the two ends outside adds at most 1 / D. A sum over
/// slabs of a function with one peak exceeds its integral by at most the thickest slab times the peak.
double maxAttenuationAlong(const Light& light, double minAxis, double maxLength, double maxSlab);

}  // namespace tyndall

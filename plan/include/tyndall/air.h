// What the air of a light does to its light, beside scattering it: a direction and a loss. shaders/slices.fx has both.
#pragma once

#include <tyndall/light.h>

namespace tyndall {

/// Of the light on its way, 1/m; 0 without Light::albedo.
double extinction(const Light& light);

/// Henyey and Greenstein's phase function times 4 pi, 1 for g = 0, where light turns by `angle` (radians, 0: straight
/// on). It only falls with the angle, or only rises.
double phase(double g, double angle);

}  // namespace tyndall

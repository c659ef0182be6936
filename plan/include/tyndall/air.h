// What the air of a light does to its light, beside scattering it: a direction and a loss. shaders/slices.fx has both.
#pragma once

#include <tyndall/light.h>

namespace tyndall {

/// The extinction coefficient, 1/m, along both paths: lamp to particle and particle to eye. 0 without Light::albedo.
double extinction(const Light& light);

/// Henyey and Greenstein's phase function times 4 pi, where light turns by `angle` (radians, 0: straight on). `g` lies
/// in (-1, 1). For g = 0 it is 1. With g > 0 it falls as the angle grows; with g < 0 it rises.
double phase(double g, double angle);

}  // namespace tyndall

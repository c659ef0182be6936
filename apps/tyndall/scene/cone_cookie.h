// A spot light's round falloff as a cookie.
#pragma once

#include "scene.h"

namespace tyndall::app {

/// The angular falloff of KHR_lights_punctual over a square field of view of 2 * outer, times `given` if
/// there is one. Angles in radians, 0 <= inner <= outer < pi/2.
Image bakeCone(double inner, double outer, const Image* given);

}  // namespace tyndall::app

// Displayed values.
#pragma once

#include <kit/image/srgb.h>
#include <kit/image/tone_map.h>

namespace tyndall::test {

/// The displayed value of a channel's radiance, in the display's range.
inline double displayed(double radiance, double exposureStops) {
    return srgbFromLinear(static_cast<float>(toneMap(radiance, exposureStops)));
}

}  // namespace tyndall::test

// From radiance to displayed values.
//
// A pixel is multiplied by the exposure and each channel c goes through Reinhard's extended operator,
// c (1 + c / w^2) / (1 + c), which keeps dark values as they are and brings w to white; then the sRGB
// transfer function. Reinhard, Stark, Shirley, Ferwerda: "Photographic Tone Reproduction for Digital
// Images", SIGGRAPH 2002, equations 1, 2 and 4.
#pragma once

#include <kit/image/image.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace tyndall {

/// Stops that bring the log-average luminance of the lit pixels to 0.18, the key of an ordinary photograph.
/// 0 for a black picture.
double automaticExposure(const Image& picture);

/// One channel, linear in [0, 1].
double toneMap(double radiance, double exposureStops);

/// Radiance of the smallest difference that the display shows at that exposure: 1/256 of its range at the steepest
/// part of the curve, in the dark.
double displayStep(double exposureStops);

/// RGB bytes. Absent stops: automaticExposure().
std::vector<std::uint8_t> displayBytes(const Image& picture, std::optional<double> exposureStops);

}  // namespace tyndall

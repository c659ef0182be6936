// What a light's shadow map stores and how fine it is. lightClipFromLight() in <tyndall/light.h> is its projection.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "shape/light_shape.h"

namespace tyndall {

/// The slopes that `texels` texels of a shadow map of `mapSize` texels a side cover.
glm::dvec2 texelSlopes(const LightShape& shape, std::uint32_t mapSize, double texels);

/// The maximum error by which a shadow map shows a surface too near to the lamp, as a share of the distance along the
/// axis. `plane`: of the surface, in light space, unit normal, the lamp on its positive side. `axis`: metres to the
/// point where the map is read.
double mapErrorShare(const LightShape& shape, const glm::dvec4& plane, std::uint32_t mapSize, double axis);

}  // namespace tyndall

// The vertex stage must write every input of the pixel stage.
#pragma once

#include "back/reflect.h"
#include "lower/lowered.h"

namespace permgen {

/// Checks one pass after its switches were set, so inputs that only other techniques read are ignored. Vulkan
/// specification, "Interface Matching": same location and type, at least as many components.
Diagnostics check_link(const LoweredPass& pass, const LoweredModule& vertex, const Reflection& vertex_actual,
                       const LoweredModule& pixel, const Reflection& pixel_actual);

}  // namespace permgen

// Turns a parsed effect into HLSL for glslang, and into the interface that the result must have. The tables of
// locations are in lower_interface.h, the order of bindings in lower_text.h.
#pragma once

#include "front/effect.h"
#include "lower/lowered.h"

namespace permgen {

/// Fills all of Lowered except `name` and `dependencies`.
Lowered lower(const ParsedEffect& effect, const Sources& sources, Diagnostics& diagnostics);

}  // namespace permgen

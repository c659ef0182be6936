// A parsed effect to HLSL that glslang understands, and to the interface that must come out of it. The tables
// of locations are in lower_interface.h, the order of bindings in lower_text.h.
#pragma once

#include "front/effect.h"
#include "lower/lowered.h"

namespace permgen {

/// Everything of Lowered but `name` and `dependencies`.
Lowered lower(const ParsedEffect& effect, const Sources& sources, Diagnostics& diagnostics);

}  // namespace permgen

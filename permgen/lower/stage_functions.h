// Functions and resources that only some stages have.
#pragma once

#include "front/effect.h"
#include "lower/calls.h"
#include "lower/lowered.h"

namespace permgen {

/// Reports what `entry`, or a function that it may call, uses and `stage` does not have: derivatives and `discard` in a
/// compute shader; barriers, groupshared variables and writable resources in the others.
void check_stage_functions(const ParsedEffect& effect, const Sources& sources, const std::vector<Call>& calls,
                           const Function& entry, Stage stage, Diagnostics& diagnostics);

}  // namespace permgen

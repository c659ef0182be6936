// Every shader of every pass with its switches set, each distinct one computed once.
#pragma once

#include <vector>

#include "back/program.h"
#include "back/worker.h"

namespace permgen {

/// [technique][pass], as in `effect`; BuiltPass::live is left empty. `modules`: the result of compile_modules().
std::vector<std::vector<BuiltPass>> freeze_passes(const Lowered& effect, const std::vector<CompiledModule>& modules,
                                                  int jobs, const WorkerLimits& limits, Diagnostics& diagnostics);

}  // namespace permgen

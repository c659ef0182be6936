// Compiles every entry point of an effect, each in a worker of its own, and checks what came out.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "back/program.h"
#include "back/worker.h"

namespace permgen {

/// What a worker sends back: SPIR-V, or why there is none.
struct WorkerReply {
    SpirvWords code;
    std::string log;
    std::string invalid;  ///< SPIRV-Tools' complaint about `code`
};
std::string pack(const WorkerReply& reply);
WorkerReply unpack(const std::string& packed);

/// One CompiledModule for each of effect.modules, in that order. Appends to `diagnostics`; where that holds
/// an error afterwards the modules concerned are empty.
std::vector<CompiledModule> compile_modules(const Lowered& effect, int jobs, const WorkerLimits& limits,
                                            Diagnostics& diagnostics);

/// Appends those of `more` that say something new.
void append_new(Diagnostics& diagnostics, Diagnostics more);

}  // namespace permgen

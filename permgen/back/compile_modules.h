// Compiles every entry point of an effect, each in its own worker, and checks the result.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "back/program.h"
#include "back/worker.h"

namespace permgen {

/// A worker's reply: SPIR-V, or the reason for a failure.
struct WorkerReply {
    SpirvWords code;
    std::string log;
    std::string invalid;  ///< SPIRV-Tools' complaint about `code`
};
std::string pack(const WorkerReply& reply);
WorkerReply unpack(const std::string& packed);

/// One CompiledModule for each of effect.modules, in that order. Appends to `diagnostics`; modules with an error are
/// empty.
std::vector<CompiledModule> compile_modules(const Lowered& effect, int jobs, const WorkerLimits& limits,
                                            Diagnostics& diagnostics);

/// Appends those of `more` that `diagnostics` does not hold yet.
void append_new(Diagnostics& diagnostics, Diagnostics more);

}  // namespace permgen

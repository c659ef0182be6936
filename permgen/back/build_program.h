// The back end in one call: compile, specialize, reflect, link.
#pragma once

#include <optional>

#include "back/program.h"
#include "back/worker.h"

namespace permgen {

struct BuildOptions {
    int jobs = default_jobs();
    WorkerLimits limits;
};

/// Empty if `diagnostics` holds an error afterwards. The result does not depend on `options`.
std::optional<Program> build_program(Lowered effect, const BuildOptions& options, Diagnostics& diagnostics);

}  // namespace permgen

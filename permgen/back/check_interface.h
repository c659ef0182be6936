// Intended against actual: glslang accepts much that it then gives another meaning (an input at another
// location, a sampler of another dimension). What came out must be what lowering meant.
#pragma once

#include <vector>

#include "back/reflect.h"
#include "lower/lowered.h"

namespace permgen {

/// Empty when the module's interface is the intended one. Inputs and resources may be missing (unused ones
/// are dropped); outputs and switches may not.
Diagnostics check_interface(const LoweredModule& module, const std::vector<LoweredResource>& resources,
                            const Reflection& actual);

}  // namespace permgen

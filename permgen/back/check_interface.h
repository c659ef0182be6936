// Compares the intended interface with the actual one: glslang accepts some code and changes its meaning (an input at
// another location, a sampler of another dimension).
#pragma once

#include <vector>

#include "back/reflect.h"
#include "lower/lowered.h"

namespace permgen {

/// Empty when the module's interface is the intended one. Inputs and resources may be missing, because unused ones are
/// dropped. Outputs and switches must be there.
Diagnostics check_interface(const LoweredModule& module, const std::vector<LoweredResource>& resources,
                            const Reflection& actual);

}  // namespace permgen

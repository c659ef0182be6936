// The front end's log, turned into diagnostics in the author's own lines.
#pragma once

#include <string>

#include "front/diagnostic.h"
#include "lower/lowered.h"

namespace permgen {

/// One diagnostic for each thing that is wrong. What the front end says about the same line as a
/// consequence of its first complaint, its counts and its farewell are left out.
Diagnostics read_compile_log(const std::string& log, const LoweredModule& module);

}  // namespace permgen

// The front end's log, turned into diagnostics in the author's own lines.
#pragma once

#include <string>

#include "front/diagnostic.h"
#include "lower/lowered.h"

namespace permgen {

/// One diagnostic for each mistake. Later complaints about the same line follow from the first one and are
/// left out, as are the front end's counts and its last line.
Diagnostics read_compile_log(const std::string& log, const LoweredModule& module);

}  // namespace permgen

// The front end's log, turned into diagnostics in the author's own lines.
#pragma once

#include <string>

#include "front/diagnostic.h"
#include "lower/lowered.h"

namespace permgen {

/// One diagnostic for each mistake. Later errors in the same line follow from the first one. They are dropped, like the
/// front end's summary and its last line.
Diagnostics read_compile_log(const std::string& log, const LoweredModule& module);

}  // namespace permgen

// Reads an effect file: preprocess, lex, parse and lower in one call.
#pragma once

#include "front/preprocess.h"
#include "lower/lowered.h"

namespace permgen {

/// Appends to `diagnostics`. If that holds an error afterwards, the returned value must not be used.
Lowered read_effect(const std::string& path, const SourceOptions& options, Diagnostics& diagnostics);

}  // namespace permgen

// `[numthreads(X, Y, Z)]` in front of a compute shader's entry point.
#pragma once

#include "front/parse_cursor.h"

namespace permgen {

bool begins_numthreads(const ParseCursor& cursor);

/// Drops the attribute from the text, since lowering writes it before the generated entry point.
ThreadGroup parse_numthreads(ParseCursor& cursor);

}  // namespace permgen

// Tokens to a ParsedEffect: the grammar of D3D9 effect files. Function bodies and initializers stay tokens.
#pragma once

#include "front/effect.h"

namespace permgen {

/// Maximum nesting of brackets: glslang overflows its stack at some higher depth.
inline constexpr std::size_t max_bracket_depth = 256;

/// Parses all of `tokens`, which end with an End token. Continues after an error, up to twenty of them.
ParsedEffect parse(Tokens tokens, const Sources& sources, Diagnostics& diagnostics);

/// A semantic's parts; see Semantic.
Semantic parse_semantic(const Token& word);

}  // namespace permgen

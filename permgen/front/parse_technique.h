// Techniques, passes, state assignments and samplers: D3DX's additions to HLSL.
#pragma once

#include "front/parse_cursor.h"

namespace permgen {

/// Letter case does not matter in D3DX's own words: `technique`, `pass`, `VertexShader`, ...
bool same_word(std::string_view a, std::string_view b);

void parse_technique(ParseCursor& cursor);

bool is_sampler_type(const Token& token);
bool is_texture_type(const Token& token);
void parse_samplers(ParseCursor& cursor);
void parse_textures(ParseCursor& cursor);

}  // namespace permgen

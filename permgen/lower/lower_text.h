// The lowered program's text: the author's tokens on the author's lines, and generated lines between.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "front/effect.h"
#include "lower/lower_samplers.h"
#include "lower/lowered.h"

namespace permgen {

struct LoweredText {
    std::string hlsl;
    std::vector<SourceLocation> line_map;  ///< one for each line of `hlsl`
    Location line;                         ///< the author's line that is being written; file -1: none
    Location behind;                       ///< the end of the last token in the author's text
};

/// Words that glslang reserves and D3D9 HLSL allows as names, such as `point`; they get renamed_prefix.
bool is_renamed(std::string_view word);

/// A name in the spelling of the lowered text.
std::string hlsl_name(std::string_view name);

/// The tokens in the spelling of the lowered text, on one line.
std::string hlsl_text(const ParsedEffect& effect, TokenRange range);

/// Appends one generated line. `place`: the author's place for errors about it, if there is one.
void add_line(LoweredText& text, std::string_view line, SourceLocation place = {});

/// The common beginning of all modules of the effect: the author's program without D3DX's additions to HLSL, with loose
/// uniforms gathered in `cbuffer Globals`, and every resource with its binding. Appends the resources.
LoweredText author_text(const ParsedEffect& effect, const Sources& sources, const SamplerDimensions& dimensions,
                        std::vector<LoweredResource>& resources, Diagnostics& diagnostics);

}  // namespace permgen

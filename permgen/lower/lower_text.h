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
    Location line;                         ///< author's line being written; file -1: none
    Location behind;                       ///< where the last token ends in the author's text
};

/// Words that glslang keeps for itself where D3D9 HLSL lets authors use them as names, such as `point`; they
/// come out with renamed_prefix in front.
bool is_renamed(std::string_view word);

/// A name as the lowered text spells it.
std::string hlsl_name(std::string_view name);

/// The tokens as the lowered text spells them, on one line.
std::string hlsl_text(const ParsedEffect& effect, TokenRange range);

/// Appends one generated line. `place` is where a complaint about it belongs in the author's text, if anywhere.
void add_line(LoweredText& text, std::string_view line, SourceLocation place = {});

/// What every module of the effect begins with: the author's program without what D3DX added to HLSL, loose
/// uniforms gathered in `cbuffer Globals`, every resource with its binding. Appends the resources.
LoweredText author_text(const ParsedEffect& effect, const Sources& sources, const SamplerDimensions& dimensions,
                        std::vector<LoweredResource>& resources, Diagnostics& diagnostics);

}  // namespace permgen

// The C preprocessor of HLSL: what `#` lines and macros leave of an effect.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "front/lex.h"

namespace permgen {

/// Bounds that keep any input finite; exceeding one is a diagnostic. Ordinary effects stay two orders of
/// magnitude below each of them.
inline constexpr int max_include_depth = 64;
inline constexpr std::size_t max_output_tokens = 1u << 20;
inline constexpr std::size_t max_preprocessing_steps = 1u << 23;
inline constexpr std::size_t steps_of_include = 1u << 12;  ///< looking for a file costs as much as many tokens
inline constexpr int max_argument_depth = 64;              ///< macro calls within arguments of macro calls
inline constexpr std::size_t max_reported_errors = 50;

/// Where to look for includes and what is defined before the first line.
struct SourceOptions {
    std::vector<std::string> include_folders;
    std::vector<std::pair<std::string, std::string>> defines;
};

struct Preprocessed {
    Tokens tokens;                          ///< ends with an End token, placed behind the effect's last one
    std::vector<std::string> dependencies;  ///< every file read, in the order of first use, the effect first
};

/// Reads `path` and everything it includes. Every token keeps its author's place; one that a macro made has
/// the place of the macro's use. Predefined: __FILE__, __LINE__ and PERMGEN (1).
Preprocessed preprocess(const std::string& path, const SourceOptions& options, Sources& sources,
                        Diagnostics& diagnostics);

}  // namespace permgen

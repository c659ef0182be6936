// The C preprocessor of HLSL: applies `#` lines and macros.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "front/lex.h"

namespace permgen {

/// Limits that bound the work for any input; exceeding one is an error. Ordinary effects stay two orders of magnitude
/// below each limit.
inline constexpr int max_include_depth = 64;
inline constexpr std::size_t max_output_tokens = 1u << 20;
inline constexpr std::size_t max_preprocessing_steps = 1u << 23;
inline constexpr std::size_t steps_of_include = 1u << 12;  ///< the cost of a file lookup, in tokens
inline constexpr int max_argument_depth = 64;              ///< macro calls within arguments of macro calls
inline constexpr std::size_t max_reported_errors = 50;

/// The folders of includes, and the macros defined before the first line.
struct SourceOptions {
    std::vector<std::string> include_folders;
    std::vector<std::pair<std::string, std::string>> defines;
};

struct Preprocessed {
    Tokens tokens;                          ///< ends with an End token after the effect's last one
    std::vector<std::string> dependencies;  ///< every file that was read, in the order of first use; the effect comes
                                            ///< first
};

/// Reads `path` and everything it includes. Every token keeps its place in the author's text; a macro's tokens have the
/// place of the macro's use. Predefined: __FILE__, __LINE__ and PERMGEN (1).
Preprocessed preprocess(const std::string& path, const SourceOptions& options, Sources& sources,
                        Diagnostics& diagnostics);

}  // namespace permgen

// Macros: what #define remembers, and how a name becomes its body.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "front/lex.h"

namespace permgen {

struct Macro {
    std::vector<std::string_view> parameters;
    Tokens body;
    Location at;
    bool function_like = false;
    bool variadic = false;  ///< the last parameter, __VA_ARGS__, takes all remaining arguments
    bool in_use = false;    ///< its expansion is being rescanned: its name stays as it is there
};

/// What a preprocessor run shares: macros, texts, complaints, and how much work is left.
struct MacroContext {
    Sources& sources;
    Diagnostics& diagnostics;
    std::unordered_map<std::string_view, Macro> macros;  ///< keys are views into `sources`
    std::size_t steps = 0;
};

/// Thrown once a bound is exceeded and its diagnostic stands; caught in preprocess().
struct PreprocessingAborted {};

/// Adds to `steps` and aborts with a diagnostic at `at` when too many were taken.
void spend(MacroContext& context, std::size_t steps, Location at);

/// Reports an error; aborts after max_reported_errors.
void complain(MacroContext& context, const char* code, Location at, std::string message);

/// Appends to `out` what `input`, which contains no directives, expands to. `depth` counts the macro calls
/// within arguments of macro calls around it.
void expand(MacroContext& context, std::span<const Token> input, int depth, Tokens& out);

/// The characters between the tokens' first and last, for messages: blanks become one space.
std::string spelled(std::span<const Token> tokens);

}  // namespace permgen

// Macros: their definitions, and the expansion of a name to its body.
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
    bool in_use = false;    ///< its expansion is being rescanned, so its name is not expanded there
};

/// The shared state of a preprocessor run: macros, texts, diagnostics, and the remaining work.
struct MacroContext {
    Sources& sources;
    Diagnostics& diagnostics;
    std::unordered_map<std::string_view, Macro> macros;  ///< keys are views into `sources`
    std::size_t steps = 0;
};

/// Thrown when a limit is exceeded, after its diagnostic was added; caught in preprocess().
struct PreprocessingAborted {};

/// Adds to `steps` and aborts with a diagnostic at `at` if there are too many.
void spend(MacroContext& context, std::size_t steps, Location at);

/// Reports an error; aborts after max_reported_errors.
void complain(MacroContext& context, const char* code, Location at, std::string message);

/// Appends the expansion of `input`, which contains no directives, to `out`. `depth`: the number of enclosing macro
/// calls whose arguments contain `input`.
void expand(MacroContext& context, std::span<const Token> input, int depth, Tokens& out);

/// The characters between the tokens' first and last, for messages: blanks become one space.
std::string spelled(std::span<const Token> tokens);

}  // namespace permgen

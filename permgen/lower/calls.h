// Calls in the bodies of functions. Bodies are tokens, so a call is a name in front of a parenthesis.
#pragma once

#include <string_view>
#include <vector>

#include "front/effect.h"

namespace permgen {

struct Call {
    std::size_t caller;  ///< index into ParsedEffect::functions
    std::size_t name_token;
    std::vector<TokenRange> arguments;  ///< of `f()`: one empty range
};

/// In the order of the text. Intrinsics, constructors and methods (`buffer.Load(0)`) count as calls.
std::vector<Call> find_calls(const ParsedEffect& effect);

/// Marks each function that `entry` may call, and `entry` itself. Overloads are not told apart.
std::vector<bool> reachable_functions(const ParsedEffect& effect, const std::vector<Call>& calls,
                                      const Function& entry);

/// True if a parameter or a local variable of the function has that name.
bool is_shadowed(const ParsedEffect& effect, const Function& function, std::string_view name);

/// The function's tokens with that index in its body, where it stands for a global: not behind a dot, not shadowed.
bool names_global(const ParsedEffect& effect, const Function& function, std::size_t token);

}  // namespace permgen

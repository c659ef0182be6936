// Reads a state's value: Direct3D 9's number for the author's words.
#pragma once

#include <permgen/states.h>

#include <optional>
#include <span>
#include <string>

#include "d3d9/states.h"
#include "front/lex.h"

namespace permgen {

struct StateValue {
    ValueKind kind = ValueKind::Words;
    std::uint32_t bits = 0;
    std::string problem;        ///< the reason for a missing value; empty if there is a value
    const Token* at = nullptr;  ///< the token that causes the problem
};

/// Reads `tokens`, which must not be empty, as a value of `row`. The kind is Expression if they are not a literal; the
/// caller checks the names in it.
StateValue read_state_value(const d3d9::StateRow& row, std::span<const Token> tokens);

}  // namespace permgen

// A state's value, read: Direct3D 9's number for the author's words.
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
    std::string problem;        ///< why there is no value; empty where there is one
    const Token* at = nullptr;  ///< of the problem: the token in question
};

/// Reads `tokens`, which are not empty, as a value of `row`. Kind Expression where they are no literal; whether
/// the names in it exist is for the caller to find out.
StateValue read_state_value(const d3d9::StateRow& row, std::span<const Token> tokens);

}  // namespace permgen

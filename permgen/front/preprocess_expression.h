// Integer expressions: conditions of #if, and sizes of arrays.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "front/lex.h"

namespace permgen {

struct IntegerResult {
    std::optional<std::int64_t> value;
    std::string problem;  ///< the reason for a missing value
    Location at;          ///< of the problem; file -1: after the last token
};

/// The value of an identifier, or nothing if it does not name a number.
using IntegerNames = std::function<std::optional<std::int64_t>(std::string_view)>;

/// Evaluates all of `tokens` with C's operators and precedence, in 64 bits that wrap around.
IntegerResult evaluate_integer(std::span<const Token> tokens, const IntegerNames& names);

/// An integer literal's value: decimal, octal or hexadecimal, suffixes u and l allowed.
std::optional<std::int64_t> integer_literal(std::string_view text);

}  // namespace permgen

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
    std::string problem;  ///< why there is no value
    Location at;          ///< where the problem is; file -1: behind the last token
};

/// What an identifier stands for, or nothing when it is not a number's name.
using IntegerNames = std::function<std::optional<std::int64_t>(std::string_view)>;

/// Evaluates all of `tokens` with C's operators and precedence, in 64 bits that wrap around.
IntegerResult evaluate_integer(std::span<const Token> tokens, const IntegerNames& names);

/// An integer literal's value: decimal, octal or hexadecimal, suffixes u and l allowed.
std::optional<std::int64_t> integer_literal(std::string_view text);

}  // namespace permgen

// The arguments of a `compile` for the uniform parameters of its entry point.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "front/effect.h"
#include "lower/lowered.h"

namespace permgen {

struct BoundParameter {
    const Variable* parameter = nullptr;
    bool is_axis = false;  ///< true: a specialization constant with the value `bits`; false: the wrapper passes
                           ///< `expression`
    ScalarType type = ScalarType::Bool;
    std::uint32_t bits = 0;
    std::string expression;  ///< as HLSL
    Location at;             ///< of the argument
};

struct BoundEntry {
    const Function* function = nullptr;
    std::vector<BoundParameter> uniforms;  ///< in the order of the parameters
};

/// True for parameters that a `compile` fills: `uniform` ones and samplers.
bool is_uniform_parameter(const Variable& parameter);

/// Finds the entry point and checks every argument against its parameter; returns nothing after an error.
std::optional<BoundEntry> bind_arguments(const ParsedEffect& effect, const Sources& sources, const Compile& compile,
                                         Diagnostics& diagnostics);

/// The bits of a literal for a constant of `type`: `true`, `-3`, `(0.5f)`. Nothing if the tokens are not a literal;
/// `problem` is set for a literal that does not fit the type.
std::optional<std::uint32_t> literal_bits(std::span<const Token> tokens, ScalarType type, std::string& problem);

}  // namespace permgen

// The meaning of type names in an interface.
#pragma once

#include <optional>
#include <string>

#include "front/effect.h"
#include "lower/lowered.h"

namespace permgen {

/// A scalar (1x1), vector (1xN) or matrix. Half and the minimum-precision types count as float, as in the SPIR-V.
struct NumericType {
    ScalarType scalar = ScalarType::Float;
    unsigned rows = 1;
    unsigned columns = 1;
    bool is_matrix = false;

    bool is_scalar() const { return !is_matrix && columns == 1; }
};

/// Nothing for structs, samplers, double and unknown names. Sees through typedefs.
std::optional<NumericType> numeric_type(const ParsedEffect& effect, const TypeName& type);

const Struct* find_struct(const ParsedEffect& effect, const TypeName& type);

/// "sampler2D" and similar types.
bool is_sampler(const TypeName& type);

/// "float4", "bool", ... for vectors and scalars.
std::string spelling(ScalarType scalar, unsigned components);

/// "a float4x4", for messages.
std::string spelling(const NumericType& type);

/// The number of elements in `dimension`: an integer expression over literals and `static const int` globals.
std::optional<std::int64_t> array_size(const ParsedEffect& effect, TokenRange dimension);

}  // namespace permgen

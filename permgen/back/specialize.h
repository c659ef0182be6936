// Sets a module's switches permanently and removes unreachable code: the rest is what the technique needs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lower/lowered.h"

namespace permgen {

struct SpecializeResult {
    std::vector<std::uint32_t> code;  ///< empty: it failed
    std::string reason;
};

/// `constants` gives every switch of the module its value. The remaining arithmetic is unchanged (no reassociation), so
/// the result and the module specialized at pipeline creation draw the same picture, bit for bit. Unused inputs are
/// removed; all outputs stay.
SpecializeResult specialize(std::span<const std::uint32_t> code, const std::vector<LoweredConstant>& constants);

}  // namespace permgen

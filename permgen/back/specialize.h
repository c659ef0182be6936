// Sets a module's switches for good and takes out what can no longer be reached: what is left is what the
// technique needs.
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

/// `constants` gives every switch of the module its value. The arithmetic of what survives is untouched
/// (nothing is re-associated), so the result draws bit for bit what the module draws when specialized at
/// pipeline creation. Inputs that are no longer read disappear; outputs all stay.
SpecializeResult specialize(std::span<const std::uint32_t> code, const std::vector<LoweredConstant>& constants);

}  // namespace permgen

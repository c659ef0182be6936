// A rewrite that specialization needs; SPIRV-Tools offers it only together with others.
#pragma once

#include <cstdint>
#include <vector>

namespace permgen {

/// Replaces every OpSelect whose condition is one constant (or a vector of equal constants) by a copy of
/// the value it selects. True if it replaced any.
bool fold_constant_selects(std::vector<std::uint32_t>& code);

}  // namespace permgen

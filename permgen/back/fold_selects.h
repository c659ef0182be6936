// The one rewrite that specialization needs and SPIRV-Tools offers only together with others.
#pragma once

#include <cstdint>
#include <vector>

namespace permgen {

/// Replaces every OpSelect whose condition is one constant (or a vector of equal constants) by a copy of
/// the value it selects. True when it replaced any.
bool fold_constant_selects(std::vector<std::uint32_t>& code);

}  // namespace permgen

// The thread group of a compute shader.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "front/effect.h"

namespace permgen {

/// The three sizes of the entry point's [numthreads], within the limits of the profile; nothing after an error.
std::optional<std::array<std::uint32_t, 3>> group_size(const ParsedEffect& effect, const Sources& sources,
                                                       const Function& entry, std::string_view profile,
                                                       Diagnostics& diagnostics);

}  // namespace permgen

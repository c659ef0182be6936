// Checks SPIR-V for Vulkan 1.3 with SPIRV-Tools' validator.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace permgen {

/// Empty if `code` is valid, else the validator's first message.
std::string validate_spirv(std::span<const std::uint32_t> code);

}  // namespace permgen

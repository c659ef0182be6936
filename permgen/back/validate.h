// SPIR-V as Vulkan 1.3 wants it, by SPIRV-Tools' validator.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace permgen {

/// Empty when `code` is valid, else the validator's first complaint.
std::string validate_spirv(std::span<const std::uint32_t> code);

}  // namespace permgen

// Removes what a module only declares.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace permgen {

/// The module without variables that nothing uses. glslang declares every resource of the text in every module, but a
/// vertex or pixel module may not declare a writable one (Vulkan 1.3, "Validation Rules within a Module").
/// Empty if `code` is no module.
std::vector<std::uint32_t> drop_unused_variables(std::span<const std::uint32_t> code);

}  // namespace permgen

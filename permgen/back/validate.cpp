#include "back/validate.h"

#include <spirv-tools/libspirv.hpp>

namespace permgen {

std::string validate_spirv(std::span<const std::uint32_t> code) {
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    std::string complaint;
    tools.SetMessageConsumer([&](spv_message_level_t level, const char*, const spv_position_t&, const char* message) {
        if (complaint.empty() && level <= SPV_MSG_ERROR) complaint = message;
    });
    if (tools.Validate(code.data(), code.size())) return {};
    return complaint.empty() ? "no reason given" : complaint;
}

}  // namespace permgen

#include "back/drop_unused.h"

#include <spirv-tools/optimizer.hpp>

namespace permgen {

std::vector<std::uint32_t> drop_unused_variables(std::span<const std::uint32_t> code) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
    optimizer.RegisterPass(spvtools::CreateDeadVariableEliminationPass());
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);  // validate.h checks afterwards
    std::vector<std::uint32_t> out;
    if (!optimizer.Run(code.data(), code.size(), &out, options)) out.clear();
    return out;
}

}  // namespace permgen

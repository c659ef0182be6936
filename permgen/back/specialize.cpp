#include "back/specialize.h"

#include <spirv-tools/optimizer.hpp>
#include <unordered_map>

#include "back/fold_selects.h"

namespace permgen {
namespace {

// Constants are propagated through calls, locals and branches. SPIRV-Tools' passes that rewrite arithmetic
// (simplification, strength reduction) are left out: they merge multiplications by constants, which changes the last
// bits.
void register_passes(spvtools::Optimizer& optimizer) {
    optimizer.RegisterPass(spvtools::CreateWrapOpKillPass())
        .RegisterPass(spvtools::CreateMergeReturnPass())
        .RegisterPass(spvtools::CreateInlineExhaustivePass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreatePrivateToLocalPass())
        .RegisterPass(spvtools::CreateScalarReplacementPass(0))
        .RegisterPass(spvtools::CreateLocalAccessChainConvertPass())
        .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
        .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
        .RegisterPass(spvtools::CreateSSARewritePass())
        .RegisterPass(spvtools::CreateCCPPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateCFGCleanupPass())
        .RegisterPass(spvtools::CreateBlockMergePass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass())
        .RegisterPass(spvtools::CreateVectorDCEPass())
        .RegisterPass(spvtools::CreateDeadInsertElimPass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass())
        .RegisterPass(spvtools::CreateEliminateDeadConstantPass())
        .RegisterPass(spvtools::CreateDeadVariableEliminationPass())
        .RegisterPass(spvtools::CreateRemoveUnusedInterfaceVariablesPass())
        .RegisterPass(spvtools::CreateRemoveDuplicatesPass())
        .RegisterPass(spvtools::CreateCompactIdsPass());
}

}  // namespace

SpecializeResult specialize(std::span<const std::uint32_t> code, const std::vector<LoweredConstant>& constants) {
    SpecializeResult result;
    const auto run = [&](const std::function<void(spvtools::Optimizer&)>& add_passes) {
        spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
        optimizer.SetMessageConsumer(
            [&](spv_message_level_t level, const char*, const spv_position_t&, const char* message) {
                if (result.reason.empty() && level <= SPV_MSG_ERROR) result.reason = message;
            });
        add_passes(optimizer);
        spvtools::OptimizerOptions options;
        options.set_run_validator(false);  // validate.h checks before and after
        std::vector<std::uint32_t> out;
        if (!optimizer.Run(result.code.data(), result.code.size(), &out, options)) return false;
        result.code = std::move(out);
        return true;
    };

    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> values;
    for (const LoweredConstant& constant : constants) values[constant.id] = {constant.bits};
    result.code.assign(code.begin(), code.end());
    bool good = run([&](spvtools::Optimizer& optimizer) {
        optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
            .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
            .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass());
        register_passes(optimizer);
    });
    // `switch ? a : b` on values is a select, which only the simplification pass would fold. Folding one may decide the
    // condition of another.
    while (good && fold_constant_selects(result.code)) good = run(register_passes);
    if (!good) {
        result.code.clear();
        if (result.reason.empty()) result.reason = "no reason given";
    }
    return result;
}

}  // namespace permgen

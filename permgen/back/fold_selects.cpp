#include "back/fold_selects.h"

#include <optional>
#include <span>
#include <spirv/unified1/spirv.hpp>
#include <unordered_map>

#include "common/spirv_module.h"

namespace permgen {
namespace {

/// Result ids of boolean constants, and of vectors with equal components.
std::unordered_map<std::uint32_t, bool> constant_conditions(std::span<const std::uint32_t> code) {
    std::unordered_map<std::uint32_t, bool> known;
    for_each_instruction(code, [&](const SpirvInstruction& instruction) {
        const auto& words = instruction.operands;
        if (instruction.opcode == spv::OpConstantTrue || instruction.opcode == spv::OpConstantFalse) {
            known[words[1]] = instruction.opcode == spv::OpConstantTrue;
        } else if (instruction.opcode == spv::OpConstantComposite || instruction.opcode == spv::OpCompositeConstruct) {
            std::optional<bool> common;
            for (const std::uint32_t part : words.subspan(2)) {
                const auto found = known.find(part);
                if (found == known.end() || (common && *common != found->second)) return;
                common = found->second;
            }
            if (common) known[words[1]] = *common;
        }
    });
    return known;
}

}  // namespace

bool fold_constant_selects(std::vector<std::uint32_t>& code) {
    const auto known = constant_conditions(code);
    std::vector<std::uint32_t> out(code.begin(), code.begin() + 5);
    bool folded = false;
    for_each_instruction(code, [&](const SpirvInstruction& instruction) {
        const auto& words = instruction.operands;
        const auto condition = instruction.opcode == spv::OpSelect ? known.find(words[2]) : known.end();
        if (condition != known.end()) {
            constexpr std::uint32_t copy_words = 4;
            out.insert(out.end(), {copy_words << 16 | spv::OpCopyObject, words[0], words[1],
                                   condition->second ? words[3] : words[4]});
            folded = true;
        } else {
            out.push_back(static_cast<std::uint32_t>(words.size() + 1) << 16 | instruction.opcode);
            out.insert(out.end(), words.begin(), words.end());
        }
    });
    if (folded) code = std::move(out);
    return folded;
}

}  // namespace permgen

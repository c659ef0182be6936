#include "block_layout.h"

#include <common/names.h>
#include <common/spirv_module.h>
#include <fmt/format.h>
#include <kit/fail.h>

#include <optional>
#include <spirv/unified1/spirv.hpp>

namespace tyndall::rig {
namespace {

using permgen::SpirvModule;

/// A member's type id and its decorations in one module.
struct Declared {
    const SpirvModule* module;
    std::uint32_t type;
    SpirvModule::Decorations decorations;
};

std::uint32_t decoration(const SpirvModule::Decorations& all, spv::Decoration kind) {
    const auto found = all.find(kind);
    return found == all.end() ? 0 : found->second;
}

std::uint32_t decorationOf(const SpirvModule& module, std::uint32_t id, spv::Decoration kind) {
    const auto found = module.decorations.find(id);
    return found == module.decorations.end() ? 0 : decoration(found->second, kind);
}

std::optional<Declared> findMember(const SpirvModule& module, const permgen::Resource& block, std::uint32_t offset) {
    for (const SpirvModule::Variable& variable : module.variables) {
        if (variable.storage != spv::StorageClassUniform ||
            decorationOf(module, variable.id, spv::DecorationDescriptorSet) != block.set ||
            decorationOf(module, variable.id, spv::DecorationBinding) != block.binding)
            continue;
        const std::uint32_t type = module.declarations.at(variable.pointer_type).operands.at(1);
        const auto& members = module.declarations.at(type).operands;
        for (std::uint32_t i = 0; i < members.size(); ++i) {
            const auto decorations = module.member_decorations.find({type, i});
            if (decorations != module.member_decorations.end() &&
                decoration(decorations->second, spv::DecorationOffset) == offset)
                return Declared{&module, members[i], decorations->second};
        }
    }
    return std::nullopt;
}

bool describe(const Declared& declared, BlockMember& member) {
    const SpirvModule& module = *declared.module;
    std::uint32_t id = declared.type;
    const auto* type = &module.declarations.at(id);
    if (type->opcode == spv::OpTypeArray) {
        member.array = true;
        member.elements = module.declarations.at(type->operands.at(1)).operands.at(1);
        member.elementStride = decorationOf(module, id, spv::DecorationArrayStride);
        id = type->operands.at(0);
        type = &module.declarations.at(id);
    }
    if (type->opcode == spv::OpTypeMatrix) {
        // HLSL's rows are SPIR-V's columns, so HLSL's "row major" is SPIR-V's column major.
        const std::uint32_t stride = decoration(declared.decorations, spv::DecorationMatrixStride);
        const bool transposed = declared.decorations.contains(spv::DecorationRowMajor);
        member.rows = type->operands.at(1);
        member.rowStride = transposed ? 4 : stride;
        member.columnStride = transposed ? stride : 4;
        id = type->operands.at(0);
        type = &module.declarations.at(id);
    }
    if (type->opcode == spv::OpTypeVector) {
        member.columns = type->operands.at(1);
        id = type->operands.at(0);
        type = &module.declarations.at(id);
    }
    if (type->opcode == spv::OpTypeFloat)
        member.type = permgen::ScalarType::Float;
    else if (type->opcode == spv::OpTypeInt)
        member.type = type->operands.at(1) != 0 ? permgen::ScalarType::Int : permgen::ScalarType::Uint;
    else
        return false;
    return type->operands.at(0) == 32;
}

}  // namespace

std::string BlockMember::typeName() const {
    if (!settable) return "a structure";
    std::string word(permgen::scalar_name(type));
    if (rows > 1)
        word += fmt::format("{}x{}", rows, columns);
    else if (columns > 1)
        word += std::to_string(columns);
    return array ? fmt::format("{}[{}]", word, elements) : word;
}

Result<std::vector<BlockMember>> blockMembers(const permgen::Effect& effect) {
    std::vector<SpirvModule> modules(effect.modules.size());
    for (std::size_t i = 0; i < modules.size(); ++i)
        if (!permgen::parse_spirv(effect.modules[i]->code, modules[i]))
            return failWith(
                fmt::format("the module {} is not SPIR-V; compile the effect again", effect.modules[i]->name));

    std::vector<BlockMember> members;
    for (const permgen::Member& known : effect.members) {
        BlockMember member;
        member.name = known.name;
        member.block = permgen::find_resource(effect, known.block);
        // Elements of storage buffers are no constants.
        if (member.block && member.block->kind != permgen::ResourceKind::UniformBuffer) continue;
        member.offset = known.offset;
        member.size = known.size;
        std::optional<Declared> declared;
        for (const SpirvModule& module : modules)
            if (member.block && !declared) declared = findMember(module, *member.block, known.offset);
        if (!declared)
            return failWith(fmt::format("no module declares the constant {} of {}; compile the effect again",
                                        known.name, known.block));
        member.settable = describe(*declared, member);
        members.push_back(std::move(member));
    }
    return members;
}

}  // namespace tyndall::rig

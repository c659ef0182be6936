#include "common/spirv_module.h"

#include <spirv/unified1/spirv.hpp>

#include "common/names.h"

namespace permgen {

bool for_each_instruction(std::span<const std::uint32_t> code,
                          const std::function<void(const SpirvInstruction&)>& visit) {
    constexpr std::size_t header_words = 5;
    if (code.size() < header_words || code[0] != spv::MagicNumber) return false;
    for (std::size_t at = header_words; at < code.size();) {
        const std::size_t length = code[at] >> 16;
        if (length == 0 || length > code.size() - at) return false;
        visit({static_cast<std::uint16_t>(code[at] & 0xffffu), code.subspan(at + 1, length - 1)});
        at += length;
    }
    return true;
}

std::string spirv_literal(std::span<const std::uint32_t> operands, std::size_t first, std::size_t* next) {
    std::string text;
    for (std::size_t word = first; word < operands.size(); ++word)
        for (int byte = 0; byte < 4; ++byte) {
            const char c = static_cast<char>((operands[word] >> (8 * byte)) & 0xffu);
            if (c == '\0') {
                if (next) *next = word + 1;
                return text;
            }
            text.push_back(c);
        }
    if (next) *next = operands.size();
    return text;
}

namespace {

/// The author's name, without the prefix that lowering adds to glslang's reserved words.
std::string author_name(const std::string& name) {
    return name.starts_with(renamed_prefix) ? name.substr(renamed_prefix.size()) : name;
}

void read_annotation(const SpirvInstruction& instruction, SpirvModule& module) {
    const auto& words = instruction.operands;
    switch (instruction.opcode) {
        case spv::OpName:
            module.names[words[0]] = author_name(spirv_literal(words, 1));
            break;
        case spv::OpMemberName:
            module.member_names[{words[0], words[1]}] = author_name(spirv_literal(words, 2));
            break;
        case spv::OpDecorate:
            module.decorations[words[0]][words[1]] = words.size() > 2 ? words[2] : 0;
            break;
        case spv::OpMemberDecorate:
            module.member_decorations[{words[0], words[1]}][words[2]] = words.size() > 3 ? words[3] : 0;
            break;
        case spv::OpEntryPoint: {
            SpirvModule::EntryPoint entry{words[0], {}, {}, {}};
            std::size_t next = 0;
            entry.name = spirv_literal(words, 2, &next);
            entry.interface.assign(words.begin() + static_cast<std::ptrdiff_t>(next), words.end());
            module.entries.push_back(std::move(entry));
            break;
        }
        case spv::OpExecutionMode:  // a module of ours has one entry point, and its modes come behind it
            if (words[1] == spv::ExecutionModeLocalSize && words.size() == 5 && !module.entries.empty())
                module.entries.back().local_size = {words[2], words[3], words[4]};
            break;
        default:
            break;
    }
}

void read_declaration(const SpirvInstruction& instruction, SpirvModule& module) {
    const auto& words = instruction.operands;
    switch (instruction.opcode) {
        case spv::OpTypeVoid:
        case spv::OpTypeBool:
        case spv::OpTypeInt:
        case spv::OpTypeFloat:
        case spv::OpTypeVector:
        case spv::OpTypeMatrix:
        case spv::OpTypeImage:
        case spv::OpTypeSampler:
        case spv::OpTypeSampledImage:
        case spv::OpTypeArray:
        case spv::OpTypeRuntimeArray:
        case spv::OpTypeStruct:
        case spv::OpTypePointer:
            module.declarations[words[0]] = {instruction.opcode, {words.begin() + 1, words.end()}};
            break;
        case spv::OpSpecConstantTrue:
        case spv::OpSpecConstantFalse:
        case spv::OpSpecConstant:
            module.spec_constants.push_back(words[1]);
            [[fallthrough]];
        case spv::OpConstant: {
            SpirvModule::Declaration declaration{instruction.opcode, {words[0]}};
            declaration.operands.insert(declaration.operands.end(), words.begin() + 2, words.end());
            module.declarations[words[1]] = std::move(declaration);
            break;
        }
        case spv::OpVariable:
            if (words[2] != spv::StorageClassFunction) module.variables.push_back({words[1], words[0], words[2]});
            break;
        default:
            break;
    }
}

}  // namespace

bool parse_spirv(std::span<const std::uint32_t> code, SpirvModule& module) {
    return for_each_instruction(code, [&](const SpirvInstruction& instruction) {
        read_annotation(instruction, module);
        read_declaration(instruction, module);
    });
}

}  // namespace permgen

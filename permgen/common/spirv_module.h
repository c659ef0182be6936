// SPIR-V's binary form: a header of five words, then instructions whose first word holds length and
// opcode (SPIR-V specification, section 2.3).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace permgen {

struct SpirvInstruction {
    std::uint16_t opcode;
    std::span<const std::uint32_t> operands;  ///< the words after the first
};

/// Calls `visit` for each instruction in order; false if a length exceeds the end.
bool for_each_instruction(std::span<const std::uint32_t> code,
                          const std::function<void(const SpirvInstruction&)>& visit);

/// The nul-terminated literal that starts at `operands[first]`; `next`, if given, receives the index after it.
std::string spirv_literal(std::span<const std::uint32_t> operands, std::size_t first, std::size_t* next = nullptr);

/// The declarations of a module, by result id.
struct SpirvModule {
    struct Declaration {
        std::uint16_t opcode = 0;
        std::vector<std::uint32_t> operands;  ///< without the result id; result type, where there is one, first
    };
    struct Variable {
        std::uint32_t id;
        std::uint32_t pointer_type;
        std::uint32_t storage;
    };
    struct EntryPoint {
        std::uint32_t model;
        std::string name;
        std::vector<std::uint32_t> interface;
        std::array<std::uint32_t, 3> local_size{};  ///< of a compute shader
    };
    using Decorations = std::map<std::uint32_t, std::uint32_t>;  ///< spv::Decoration to its first operand, or 0

    std::vector<EntryPoint> entries;
    std::unordered_map<std::uint32_t, Declaration> declarations;  ///< types and constants
    std::vector<std::uint32_t> spec_constants;                    ///< in order of declaration
    std::vector<Variable> variables;                              ///< of module scope, in order of declaration
    std::unordered_map<std::uint32_t, std::string> names;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> member_names;
    std::unordered_map<std::uint32_t, Decorations> decorations;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Decorations> member_decorations;
};

/// False if the words are not a SPIR-V module.
bool parse_spirv(std::span<const std::uint32_t> code, SpirvModule& module);

}  // namespace permgen

// What a SPIR-V module declares to the outside: inputs, outputs, resources, block layouts, switches.
#pragma once

#include <permgen/tables.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace permgen {

/// One location of an input or output, or one built-in; matrices and arrays give one entry a location.
struct ReflectedVariable {
    std::string name;
    bool builtin = false;
    std::uint32_t builtin_kind = 0;  ///< spv::BuiltIn
    std::uint32_t location = 0;
    std::uint32_t components = 0;  ///< of a built-in array: its length
    ScalarType type = ScalarType::Float;
};

struct ReflectedResource {
    std::string name;
    ResourceKind kind = ResourceKind::UniformBuffer;
    ImageDimension dimension = ImageDimension::None;
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
    std::uint32_t size = 0;  ///< bytes of a block or of a storage buffer's element
    ImageFormat format = ImageFormat::None;
    bool writable = false;
};

struct ReflectedMember {
    std::string block;
    std::string name;
    std::uint32_t offset = 0;
    std::uint32_t size = 0;  ///< bytes from its offset to its last used byte, padding of array elements included

    bool operator==(const ReflectedMember&) const = default;
};

struct ReflectedConstant {
    std::string name;
    std::uint32_t id = 0;
    ScalarType type = ScalarType::Bool;
    std::uint32_t default_bits = 0;
};

struct Reflection {
    std::string entry;
    Stage stage = Stage::Vertex;
    std::array<std::uint32_t, 3> group_size{};  ///< of a compute shader
    std::vector<ReflectedVariable> inputs;      ///< by location, built-ins last
    std::vector<ReflectedVariable> outputs;     ///< likewise
    std::vector<ReflectedResource> resources;   ///< by set and binding
    std::vector<ReflectedMember> members;       ///< by block, then offset
    std::vector<ReflectedConstant> constants;   ///< by id
};

/// Reads a module that SPIRV-Tools found valid. Fails with a reason unless the module has exactly one entry point,
/// vertex, pixel or compute, and only resources that the tables can express.
struct ReflectResult {
    std::optional<Reflection> reflection;
    std::string reason;
};
ReflectResult reflect(std::span<const std::uint32_t> code);

}  // namespace permgen

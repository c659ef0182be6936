#include "back/reflect.h"

#include <algorithm>
#include <spirv/unified1/spirv.hpp>
#include <stdexcept>

#include "common/spirv_module.h"

namespace permgen {
namespace {

/// Thrown and caught in this file only: the tables cannot express the module.
struct Unsupported : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Reader {
public:
    explicit Reader(const SpirvModule& module) : module_(module) {}
    Reflection read() const;

private:
    using Declaration = SpirvModule::Declaration;

    const Declaration& declaration(std::uint32_t id) const;
    std::uint32_t array_length(const Declaration& array) const;
    std::string name(std::uint32_t id) const;
    std::optional<std::uint32_t> decoration(std::uint32_t id, spv::Decoration kind) const;
    std::optional<std::uint32_t> member_decoration(std::uint32_t id, std::uint32_t member, spv::Decoration kind) const;

    ScalarType scalar_type(std::uint32_t type) const;
    void add_locations(const std::string& name, std::uint32_t type, std::uint32_t& location,
                       std::vector<ReflectedVariable>& out) const;
    void add_builtin(const std::string& name, std::uint32_t kind, std::uint32_t type,
                     std::vector<ReflectedVariable>& out) const;
    void add_interface(const SpirvModule::Variable& variable, std::vector<ReflectedVariable>& out) const;
    std::uint32_t byte_size(std::uint32_t type, std::uint32_t matrix_stride, bool row_major) const;
    std::uint32_t struct_size(std::uint32_t type) const;
    std::uint32_t member_size(std::uint32_t type, std::uint32_t member) const;
    void add_block(const SpirvModule::Variable& variable, std::uint32_t type, Reflection& out) const;
    void add_sampler(const SpirvModule::Variable& variable, std::uint32_t type, Reflection& out) const;
    void add_constant(std::uint32_t id, Reflection& out) const;

    const SpirvModule& module_;
};

const SpirvModule::Declaration& Reader::declaration(std::uint32_t id) const {
    const auto found = module_.declarations.find(id);
    if (found == module_.declarations.end()) throw Unsupported("it uses a type that permgen does not know");
    return found->second;
}

std::uint32_t Reader::array_length(const Declaration& array) const {
    if (array.opcode != spv::OpTypeArray) throw Unsupported("it has an array without a length");
    const Declaration& length = declaration(array.operands[1]);
    if (length.opcode != spv::OpConstant) throw Unsupported("the length of an array depends on a switch");
    return length.operands[1];
}

std::string Reader::name(std::uint32_t id) const {
    const auto found = module_.names.find(id);
    return found == module_.names.end() ? std::string() : found->second;
}

std::optional<std::uint32_t> Reader::decoration(std::uint32_t id, spv::Decoration kind) const {
    const auto all = module_.decorations.find(id);
    if (all == module_.decorations.end()) return std::nullopt;
    const auto found = all->second.find(kind);
    return found == all->second.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::uint32_t> Reader::member_decoration(std::uint32_t id, std::uint32_t member,
                                                       spv::Decoration kind) const {
    const auto all = module_.member_decorations.find({id, member});
    if (all == module_.member_decorations.end()) return std::nullopt;
    const auto found = all->second.find(kind);
    return found == all->second.end() ? std::nullopt : std::optional(found->second);
}

ScalarType Reader::scalar_type(std::uint32_t id) const {
    const Declaration& type = declaration(id);
    switch (type.opcode) {
        case spv::OpTypeBool:
            return ScalarType::Bool;
        case spv::OpTypeInt:
            return type.operands[1] ? ScalarType::Int : ScalarType::Uint;
        case spv::OpTypeFloat:
            return ScalarType::Float;
        default:
            throw Unsupported("it has an input, output or switch that is not a number");
    }
}

void Reader::add_locations(const std::string& variable, std::uint32_t id, std::uint32_t& location,
                           std::vector<ReflectedVariable>& out) const {
    const Declaration& type = declaration(id);
    switch (type.opcode) {
        case spv::OpTypeVector:
            out.push_back({variable, false, 0, location++, type.operands[1], scalar_type(type.operands[0])});
            break;
        case spv::OpTypeMatrix:
            for (std::uint32_t column = 0; column < type.operands[1]; ++column)
                add_locations(variable, type.operands[0], location, out);
            break;
        case spv::OpTypeArray:
            for (std::uint32_t element = 0, count = array_length(type); element < count; ++element)
                add_locations(variable, type.operands[0], location, out);
            break;
        case spv::OpTypeStruct:
            for (const std::uint32_t member : type.operands) add_locations(variable, member, location, out);
            break;
        default:
            out.push_back({variable, false, 0, location++, 1, scalar_type(id)});
    }
}

void Reader::add_builtin(const std::string& variable, std::uint32_t kind, std::uint32_t id,
                         std::vector<ReflectedVariable>& out) const {
    const Declaration& type = declaration(id);
    ReflectedVariable builtin{variable, true, kind, 0, 1, ScalarType::Float};
    if (type.opcode == spv::OpTypeArray) {
        builtin.components = array_length(type);
        builtin.type = scalar_type(type.operands[0]);
    } else if (type.opcode == spv::OpTypeVector) {
        builtin.components = type.operands[1];
        builtin.type = scalar_type(type.operands[0]);
    } else {
        builtin.type = scalar_type(id);
    }
    out.push_back(std::move(builtin));
}

void Reader::add_interface(const SpirvModule::Variable& variable, std::vector<ReflectedVariable>& out) const {
    const std::uint32_t id = declaration(variable.pointer_type).operands[1];
    if (const auto kind = decoration(variable.id, spv::DecorationBuiltIn))
        return add_builtin(name(variable.id), *kind, id, out);
    const Declaration& type = declaration(id);
    if (type.opcode == spv::OpTypeStruct && member_decoration(id, 0, spv::DecorationBuiltIn)) {
        for (std::uint32_t member = 0; member < type.operands.size(); ++member)
            if (const auto kind = member_decoration(id, member, spv::DecorationBuiltIn))
                add_builtin(name(variable.id), *kind, type.operands[member], out);
        return;
    }
    auto location = decoration(variable.id, spv::DecorationLocation);
    if (!location) throw Unsupported("'" + name(variable.id) + "' has no location");
    add_locations(name(variable.id), id, *location, out);
}

// Vulkan specification, "Offset and Stride Assignment": sizes follow from the declared strides.
std::uint32_t Reader::byte_size(std::uint32_t id, std::uint32_t matrix_stride, bool row_major) const {
    const Declaration& type = declaration(id);
    switch (type.opcode) {
        case spv::OpTypeInt:
        case spv::OpTypeFloat:
            return type.operands[0] / 8;
        case spv::OpTypeVector:
            return byte_size(type.operands[0], 0, false) * type.operands[1];
        case spv::OpTypeMatrix: {
            const std::uint32_t rows = declaration(type.operands[0]).operands[1];
            return matrix_stride * (row_major ? rows : type.operands[1]);
        }
        case spv::OpTypeArray:
            return decoration(id, spv::DecorationArrayStride).value_or(0) * array_length(type);
        case spv::OpTypeStruct:
            return struct_size(id);
        default:
            throw Unsupported("a uniform block holds something that is not a number");
    }
}

std::uint32_t Reader::member_size(std::uint32_t type, std::uint32_t member) const {
    return byte_size(declaration(type).operands[member],
                     member_decoration(type, member, spv::DecorationMatrixStride).value_or(0),
                     member_decoration(type, member, spv::DecorationRowMajor).has_value());
}

std::uint32_t Reader::struct_size(std::uint32_t type) const {
    std::uint32_t end = 0;
    for (std::uint32_t member = 0; member < declaration(type).operands.size(); ++member)
        end = std::max(end,
                       member_decoration(type, member, spv::DecorationOffset).value_or(0) + member_size(type, member));
    return (end + 15u) & ~15u;  // a block's extent is a multiple of its base alignment, 16 bytes
}

void Reader::add_block(const SpirvModule::Variable& variable, std::uint32_t type, Reflection& out) const {
    // A cbuffer's instance has no name; its type has the author's.
    ReflectedResource block;
    block.name = name(variable.id).empty() ? name(type) : name(variable.id);
    block.kind = ResourceKind::UniformBuffer;
    block.set = decoration(variable.id, spv::DecorationDescriptorSet).value_or(0);
    block.binding = decoration(variable.id, spv::DecorationBinding).value_or(0);
    block.size = struct_size(type);
    for (std::uint32_t member = 0; member < declaration(type).operands.size(); ++member) {
        const auto label = module_.member_names.find({type, member});
        out.members.push_back({block.name, label == module_.member_names.end() ? std::string() : label->second,
                               member_decoration(type, member, spv::DecorationOffset).value_or(0),
                               member_size(type, member)});
    }
    out.resources.push_back(std::move(block));
}

void Reader::add_sampler(const SpirvModule::Variable& variable, std::uint32_t type, Reflection& out) const {
    const Declaration& image = declaration(declaration(type).operands[0]);
    ReflectedResource sampler;
    sampler.name = name(variable.id);
    sampler.kind = ResourceKind::CombinedImageSampler;
    sampler.set = decoration(variable.id, spv::DecorationDescriptorSet).value_or(0);
    sampler.binding = decoration(variable.id, spv::DecorationBinding).value_or(0);
    switch (image.operands[1]) {
        case spv::Dim1D:
            sampler.dimension = ImageDimension::One;
            break;
        case spv::Dim2D:
            sampler.dimension = ImageDimension::Two;
            break;
        case spv::Dim3D:
            sampler.dimension = ImageDimension::Three;
            break;
        case spv::DimCube:
            sampler.dimension = ImageDimension::Cube;
            break;
        default:
            throw Unsupported("sampler '" + sampler.name + "' is not of a 1D, 2D, 3D or cube image");
    }
    out.resources.push_back(std::move(sampler));
}

void Reader::add_constant(std::uint32_t id, Reflection& out) const {
    const auto spec_id = decoration(id, spv::DecorationSpecId);
    if (!spec_id) return;
    const Declaration& constant = declaration(id);
    ReflectedConstant axis{name(id), *spec_id, scalar_type(constant.operands[0]), 0};
    axis.default_bits =
        constant.opcode == spv::OpSpecConstant ? constant.operands[1] : constant.opcode == spv::OpSpecConstantTrue;
    out.constants.push_back(std::move(axis));
}

Reflection Reader::read() const {
    if (module_.entries.size() != 1) throw Unsupported("it has no entry point");
    const auto& entry = module_.entries.front();
    if (entry.model != spv::ExecutionModelVertex && entry.model != spv::ExecutionModelFragment)
        throw Unsupported("it is neither a vertex nor a pixel shader");
    Reflection out;
    out.entry = entry.name;
    out.stage = entry.model == spv::ExecutionModelVertex ? Stage::Vertex : Stage::Pixel;
    for (const auto& variable : module_.variables) {
        const std::uint32_t type = declaration(variable.pointer_type).operands[1];
        const std::uint16_t kind = declaration(type).opcode;
        if (variable.storage == spv::StorageClassInput)
            add_interface(variable, out.inputs);
        else if (variable.storage == spv::StorageClassOutput)
            add_interface(variable, out.outputs);
        else if (variable.storage == spv::StorageClassUniform && kind == spv::OpTypeStruct)
            add_block(variable, type, out);
        else if (variable.storage == spv::StorageClassUniformConstant && kind == spv::OpTypeSampledImage)
            add_sampler(variable, type, out);
        else if (variable.storage != spv::StorageClassPrivate)
            throw Unsupported("'" + name(variable.id) + "' is neither a uniform block nor a sampler");
    }
    for (const std::uint32_t id : module_.spec_constants) add_constant(id, out);

    const auto by_location = [](const ReflectedVariable& a, const ReflectedVariable& b) {
        return std::tuple(a.builtin, a.builtin_kind, a.location) < std::tuple(b.builtin, b.builtin_kind, b.location);
    };
    std::stable_sort(out.inputs.begin(), out.inputs.end(), by_location);
    std::stable_sort(out.outputs.begin(), out.outputs.end(), by_location);
    std::stable_sort(out.resources.begin(), out.resources.end(), [](const auto& a, const auto& b) {
        return std::pair(a.set, a.binding) < std::pair(b.set, b.binding);
    });
    std::stable_sort(out.constants.begin(), out.constants.end(),
                     [](const auto& a, const auto& b) { return a.id < b.id; });
    return out;
}

}  // namespace

ReflectResult reflect(std::span<const std::uint32_t> code) {
    SpirvModule module;
    if (!parse_spirv(code, module)) return {std::nullopt, "it is not a SPIR-V module"};
    try {
        return {Reader(module).read(), {}};
    } catch (const Unsupported& unsupported) {
        return {std::nullopt, unsupported.what()};
    }
}

}  // namespace permgen

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
    std::uint32_t byte_size(std::uint32_t type, std::uint32_t matrix_stride, bool row_major,
                            std::uint32_t struct_multiple) const;
    std::uint32_t struct_size(std::uint32_t type, std::uint32_t multiple) const;
    std::uint32_t member_size(std::uint32_t type, std::uint32_t member, std::uint32_t struct_multiple) const;
    void add_members(const std::string& block, std::uint32_t type, std::uint32_t struct_multiple,
                     Reflection& out) const;
    ImageDimension dimension(const Declaration& image, const std::string& name) const;
    void add_block(const SpirvModule::Variable& variable, std::uint32_t type, Reflection& out) const;
    void add_sampler(const SpirvModule::Variable& variable, std::uint32_t type, Reflection& out) const;
    void add_storage_buffer(const SpirvModule::Variable& variable, std::uint32_t type, Reflection& out) const;
    void add_image(const SpirvModule::Variable& variable, std::uint32_t type, Reflection& out) const;
    ReflectedResource resource(const SpirvModule::Variable& variable, ResourceKind kind) const;
    void add_resource(const SpirvModule::Variable& variable, Reflection& out) const;
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

// Vulkan specification, "Offset and Stride Assignment": sizes follow from the declared strides. A struct's size is a
// multiple of `struct_multiple`.
std::uint32_t Reader::byte_size(std::uint32_t id, std::uint32_t matrix_stride, bool row_major,
                                std::uint32_t struct_multiple) const {
    const Declaration& type = declaration(id);
    switch (type.opcode) {
        case spv::OpTypeInt:
        case spv::OpTypeFloat:
            return type.operands[0] / 8;
        case spv::OpTypeVector:
            return byte_size(type.operands[0], 0, false, struct_multiple) * type.operands[1];
        case spv::OpTypeMatrix: {
            const std::uint32_t rows = declaration(type.operands[0]).operands[1];
            return matrix_stride * (row_major ? rows : type.operands[1]);
        }
        case spv::OpTypeArray:
            return decoration(id, spv::DecorationArrayStride).value_or(0) * array_length(type);
        case spv::OpTypeStruct:
            return struct_size(id, struct_multiple);
        default:
            throw Unsupported("a block or buffer holds something that is not a number");
    }
}

std::uint32_t Reader::member_size(std::uint32_t type, std::uint32_t member, std::uint32_t struct_multiple) const {
    return byte_size(declaration(type).operands[member],
                     member_decoration(type, member, spv::DecorationMatrixStride).value_or(0),
                     member_decoration(type, member, spv::DecorationRowMajor).has_value(), struct_multiple);
}

std::uint32_t Reader::struct_size(std::uint32_t type, std::uint32_t multiple) const {
    std::uint32_t end = 0;
    for (std::uint32_t member = 0; member < declaration(type).operands.size(); ++member)
        end = std::max(end, member_decoration(type, member, spv::DecorationOffset).value_or(0) +
                                member_size(type, member, multiple));
    return (end + multiple - 1) / multiple * multiple;
}

void Reader::add_members(const std::string& block, std::uint32_t type, std::uint32_t struct_multiple,
                         Reflection& out) const {
    for (std::uint32_t member = 0; member < declaration(type).operands.size(); ++member) {
        const auto label = module_.member_names.find({type, member});
        out.members.push_back({block, label == module_.member_names.end() ? std::string() : label->second,
                               member_decoration(type, member, spv::DecorationOffset).value_or(0),
                               member_size(type, member, struct_multiple)});
    }
}

ReflectedResource Reader::resource(const SpirvModule::Variable& variable, ResourceKind kind) const {
    ReflectedResource result;
    result.name = name(variable.id);
    result.kind = kind;
    result.set = decoration(variable.id, spv::DecorationDescriptorSet).value_or(0);
    result.binding = decoration(variable.id, spv::DecorationBinding).value_or(0);
    return result;
}

void Reader::add_block(const SpirvModule::Variable& variable, std::uint32_t type, Reflection& out) const {
    constexpr std::uint32_t block_multiple = 16;  // the base alignment of a uniform block
    ReflectedResource block = resource(variable, ResourceKind::UniformBuffer);
    // A cbuffer's instance has no name; its type has the author's.
    if (block.name.empty()) block.name = name(type);
    block.size = struct_size(type, block_multiple);
    add_members(block.name, type, block_multiple, out);
    out.resources.push_back(std::move(block));
}

void Reader::add_storage_buffer(const SpirvModule::Variable& variable, std::uint32_t type, Reflection& out) const {
    constexpr std::uint32_t scalar = 4;
    ReflectedResource buffer = resource(variable, ResourceKind::StorageBuffer);
    const std::uint32_t array = declaration(type).operands[0];
    if (declaration(type).operands.size() != 1 || declaration(array).opcode != spv::OpTypeRuntimeArray)
        throw Unsupported("'" + buffer.name + "' is not an array of elements");
    buffer.size = decoration(array, spv::DecorationArrayStride).value_or(0);
    buffer.writable =
        !member_decoration(type, 0, spv::DecorationNonWritable) && !decoration(variable.id, spv::DecorationNonWritable);
    const std::uint32_t element = declaration(array).operands[0];
    if (declaration(element).opcode == spv::OpTypeStruct) add_members(buffer.name, element, scalar, out);
    out.resources.push_back(std::move(buffer));
}

ImageDimension Reader::dimension(const Declaration& image, const std::string& resource_name) const {
    constexpr std::uint32_t arrayed = 3, multisampled = 4;  // operands, SPIR-V 1.6, OpTypeImage
    const bool plain = image.operands[arrayed] == 0 && image.operands[multisampled] == 0;
    switch (plain ? image.operands[1] : static_cast<std::uint32_t>(spv::DimMax)) {
        case spv::Dim1D:
            return ImageDimension::One;
        case spv::Dim2D:
            return ImageDimension::Two;
        case spv::Dim3D:
            return ImageDimension::Three;
        case spv::DimCube:
            return ImageDimension::Cube;
        default:
            throw Unsupported("'" + resource_name + "' is not of a 1D, 2D, 3D or cube image");
    }
}

void Reader::add_sampler(const SpirvModule::Variable& variable, std::uint32_t type, Reflection& out) const {
    ReflectedResource sampler = resource(variable, ResourceKind::CombinedImageSampler);
    sampler.dimension = dimension(declaration(declaration(type).operands[0]), sampler.name);
    out.resources.push_back(std::move(sampler));
}

ImageFormat format_of(std::uint32_t spirv_format, const std::string& resource_name) {
    if (spirv_format == spv::ImageFormatUnknown || spirv_format > static_cast<std::uint32_t>(ImageFormat::R8ui))
        throw Unsupported("storage image '" + resource_name + "' has a format that the tables do not know");
    return static_cast<ImageFormat>(spirv_format);  // the numbers are SPIR-V's
}
static_assert(static_cast<spv::ImageFormat>(ImageFormat::Rgba32f) == spv::ImageFormatRgba32f &&
              static_cast<spv::ImageFormat>(ImageFormat::R8ui) == spv::ImageFormatR8ui);

void Reader::add_image(const SpirvModule::Variable& variable, std::uint32_t type, Reflection& out) const {
    constexpr std::uint32_t sampled = 5, format = 6, storage = 2;  // operands, and Sampled of a storage image
    const Declaration& image = declaration(type);
    ReflectedResource result = resource(variable, ResourceKind::StorageImage);
    if (image.operands[sampled] != storage) throw Unsupported("'" + result.name + "' is an image without a sampler");
    result.dimension = dimension(image, result.name);
    result.format = format_of(image.operands[format], result.name);
    result.writable = !decoration(variable.id, spv::DecorationNonWritable);
    out.resources.push_back(std::move(result));
}

void Reader::add_resource(const SpirvModule::Variable& variable, Reflection& out) const {
    const std::uint32_t type = declaration(variable.pointer_type).operands[1];
    const std::uint16_t kind = declaration(type).opcode;
    const bool in_block = variable.storage == spv::StorageClassUniform && kind == spv::OpTypeStruct;
    // Until SPIR-V 1.3 a storage buffer is a BufferBlock of the class Uniform.
    if ((in_block && decoration(type, spv::DecorationBufferBlock)) ||
        variable.storage == spv::StorageClassStorageBuffer)
        return add_storage_buffer(variable, type, out);
    if (in_block) return add_block(variable, type, out);
    if (variable.storage == spv::StorageClassUniformConstant && kind == spv::OpTypeSampledImage)
        return add_sampler(variable, type, out);
    if (variable.storage == spv::StorageClassUniformConstant && kind == spv::OpTypeImage)
        return add_image(variable, type, out);
    throw Unsupported("'" + name(variable.id) + "' is a resource of a kind that the tables do not know");
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

constexpr std::pair<std::uint32_t, Stage> models[] = {{spv::ExecutionModelVertex, Stage::Vertex},
                                                      {spv::ExecutionModelFragment, Stage::Pixel},
                                                      {spv::ExecutionModelGLCompute, Stage::Compute}};

Reflection Reader::read() const {
    if (module_.entries.size() != 1) throw Unsupported("it has no entry point");
    const auto& entry = module_.entries.front();
    const auto stage = std::find_if(std::begin(models), std::end(models),
                                    [&](const auto& model) { return model.first == entry.model; });
    if (stage == std::end(models)) throw Unsupported("it is not a vertex, pixel or compute shader");
    Reflection out;
    out.entry = entry.name;
    out.stage = stage->second;
    out.group_size = entry.local_size;
    for (const auto& variable : module_.variables) {
        const bool is_private = variable.storage == spv::StorageClassPrivate ||
                                (variable.storage == spv::StorageClassWorkgroup && out.stage == Stage::Compute);
        if (variable.storage == spv::StorageClassInput)
            add_interface(variable, out.inputs);
        else if (variable.storage == spv::StorageClassOutput)
            add_interface(variable, out.outputs);
        else if (!is_private)
            add_resource(variable, out);
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

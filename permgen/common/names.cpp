#include "common/names.h"

#include "d3d9/image_formats.h"
#include "d3d9/states.h"

namespace permgen {

std::string_view scalar_name(ScalarType type) {
    constexpr std::string_view names[] = {"bool", "int", "uint", "float"};
    return names[static_cast<int>(type)];
}

std::string type_name(ScalarType type, std::uint32_t components) {
    return std::string(scalar_name(type)) + (components > 1 ? std::to_string(components) : std::string());
}

std::string_view stage_name(Stage stage) {
    constexpr std::string_view names[] = {"vertex", "pixel", "compute"};
    return names[static_cast<int>(stage)];
}

std::string_view kind_name(ResourceKind kind) {
    constexpr std::string_view names[] = {"uniform-buffer", "combined-image-sampler", "storage-image",
                                          "storage-buffer"};
    return names[static_cast<int>(kind)];
}

std::string_view dimension_name(ImageDimension dimension) {
    constexpr std::string_view names[] = {"", "1d", "2d", "3d", "cube"};
    return names[static_cast<int>(dimension)];
}

std::string_view format_name(ImageFormat format) {
    return format == ImageFormat::None ? std::string_view() : d3d9::row_of(format).name;
}

std::string_view state_name(StateId id) {
    return id == StateId::Unknown ? "Unknown" : d3d9::row_of(id).name;
}

std::string_view value_kind_name(ValueKind kind) {
    constexpr std::string_view names[] = {"words", "bool",   "enum",   "integer",   "float",
                                          "flags", "colour", "object", "expression"};
    return names[static_cast<int>(kind)];
}

std::string resource_name(ResourceKind kind, ImageDimension dimension) {
    if (kind == ResourceKind::UniformBuffer) return "uniform block";
    if (kind == ResourceKind::StorageBuffer) return "storage buffer";
    if (kind == ResourceKind::StorageImage) return "storage image " + std::string(dimension_name(dimension));
    constexpr std::string_view names[] = {"sampler", "sampler1D", "sampler2D", "sampler3D", "samplerCUBE"};
    return std::string(names[static_cast<int>(dimension)]);
}

}  // namespace permgen

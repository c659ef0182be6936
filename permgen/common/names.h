// The words for types and kinds, in diagnostics and in the manifest; the prefix of names in SPIR-V.
#pragma once

#include <permgen/tables.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace permgen {

/// The prefix of author's names that glslang reserves (`point`, `sampler`, ...). Such members and resources have it in
/// the SPIR-V, and not in permgen's output.
inline constexpr std::string_view renamed_prefix = "permgen_id_";

std::string_view scalar_name(ScalarType type);                           ///< "bool", "int", "uint", "float"
std::string type_name(ScalarType type, std::uint32_t components);        ///< "float4", as in HLSL
std::string_view stage_name(Stage stage);                                ///< "vertex", "pixel", "compute"
std::string_view kind_name(ResourceKind kind);                           ///< "uniform-buffer", "storage-image"
std::string_view dimension_name(ImageDimension dimension);               ///< "1d", "2d", "3d", "cube"; empty for None
std::string_view format_name(ImageFormat format);                        ///< "rgba32f"; empty for None
std::string_view state_name(StateId id);                                 ///< "SrcBlend"
std::string_view value_kind_name(ValueKind kind);                        ///< "enum", "flags"
std::string resource_name(ResourceKind kind, ImageDimension dimension);  ///< "uniform block", "sampler2D"

}  // namespace permgen

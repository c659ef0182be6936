// The formats of a storage image's texels. Direct3D leaves them to the application's view; Vulkan wants them in the
// shader. The names are those that DXC's [[vk::image_format("...")]] takes.
#pragma once

#include <permgen/tables.h>

#include <string_view>

namespace permgen::d3d9 {

struct ImageFormatRow {
    ImageFormat format;
    std::string_view name;
    std::string_view enumerator;  ///< of ImageFormat
    ScalarType scalar;            ///< of an element in the shader
    std::uint32_t components;
};

/// In the order of ImageFormat, without None.
inline constexpr ImageFormatRow image_formats[] = {
    {ImageFormat::Rgba32f, "rgba32f", "Rgba32f", ScalarType::Float, 4},
    {ImageFormat::Rgba16f, "rgba16f", "Rgba16f", ScalarType::Float, 4},
    {ImageFormat::R32f, "r32f", "R32f", ScalarType::Float, 1},
    {ImageFormat::Rgba8, "rgba8", "Rgba8", ScalarType::Float, 4},
    {ImageFormat::Rgba8snorm, "rgba8snorm", "Rgba8snorm", ScalarType::Float, 4},
    {ImageFormat::Rg32f, "rg32f", "Rg32f", ScalarType::Float, 2},
    {ImageFormat::Rg16f, "rg16f", "Rg16f", ScalarType::Float, 2},
    {ImageFormat::R11g11b10f, "r11g11b10f", "R11g11b10f", ScalarType::Float, 3},
    {ImageFormat::R16f, "r16f", "R16f", ScalarType::Float, 1},
    {ImageFormat::Rgba16, "rgba16", "Rgba16", ScalarType::Float, 4},
    {ImageFormat::Rgb10a2, "rgb10a2", "Rgb10a2", ScalarType::Float, 4},
    {ImageFormat::Rg16, "rg16", "Rg16", ScalarType::Float, 2},
    {ImageFormat::Rg8, "rg8", "Rg8", ScalarType::Float, 2},
    {ImageFormat::R16, "r16", "R16", ScalarType::Float, 1},
    {ImageFormat::R8, "r8", "R8", ScalarType::Float, 1},
    {ImageFormat::Rgba16snorm, "rgba16snorm", "Rgba16snorm", ScalarType::Float, 4},
    {ImageFormat::Rg16snorm, "rg16snorm", "Rg16snorm", ScalarType::Float, 2},
    {ImageFormat::Rg8snorm, "rg8snorm", "Rg8snorm", ScalarType::Float, 2},
    {ImageFormat::R16snorm, "r16snorm", "R16snorm", ScalarType::Float, 1},
    {ImageFormat::R8snorm, "r8snorm", "R8snorm", ScalarType::Float, 1},
    {ImageFormat::Rgba32i, "rgba32i", "Rgba32i", ScalarType::Int, 4},
    {ImageFormat::Rgba16i, "rgba16i", "Rgba16i", ScalarType::Int, 4},
    {ImageFormat::Rgba8i, "rgba8i", "Rgba8i", ScalarType::Int, 4},
    {ImageFormat::R32i, "r32i", "R32i", ScalarType::Int, 1},
    {ImageFormat::Rg32i, "rg32i", "Rg32i", ScalarType::Int, 2},
    {ImageFormat::Rg16i, "rg16i", "Rg16i", ScalarType::Int, 2},
    {ImageFormat::Rg8i, "rg8i", "Rg8i", ScalarType::Int, 2},
    {ImageFormat::R16i, "r16i", "R16i", ScalarType::Int, 1},
    {ImageFormat::R8i, "r8i", "R8i", ScalarType::Int, 1},
    {ImageFormat::Rgba32ui, "rgba32ui", "Rgba32ui", ScalarType::Uint, 4},
    {ImageFormat::Rgba16ui, "rgba16ui", "Rgba16ui", ScalarType::Uint, 4},
    {ImageFormat::Rgba8ui, "rgba8ui", "Rgba8ui", ScalarType::Uint, 4},
    {ImageFormat::R32ui, "r32ui", "R32ui", ScalarType::Uint, 1},
    {ImageFormat::Rgb10a2ui, "rgb10a2ui", "Rgb10a2ui", ScalarType::Uint, 4},
    {ImageFormat::Rg32ui, "rg32ui", "Rg32ui", ScalarType::Uint, 2},
    {ImageFormat::Rg16ui, "rg16ui", "Rg16ui", ScalarType::Uint, 2},
    {ImageFormat::Rg8ui, "rg8ui", "Rg8ui", ScalarType::Uint, 2},
    {ImageFormat::R16ui, "r16ui", "R16ui", ScalarType::Uint, 1},
    {ImageFormat::R8ui, "r8ui", "R8ui", ScalarType::Uint, 1},
};

/// The row of that format, which must not be None.
constexpr const ImageFormatRow& row_of(ImageFormat format) {
    return image_formats[static_cast<std::size_t>(format) - 1];
}

constexpr bool formats_are_in_order() {
    for (const ImageFormatRow& row : image_formats)
        if (&row_of(row.format) != &row) return false;
    return true;
}
static_assert(formats_are_in_order());

/// The format of that name, or nullptr.
constexpr const ImageFormatRow* find_image_format(std::string_view name) {
    for (const ImageFormatRow& row : image_formats)
        if (row.name == name) return &row;
    return nullptr;
}

}  // namespace permgen::d3d9

// Every state of Direct3D 9 that D3DX reads from an effect: its name, its values, and its support here. permgen checks
// effects against this table, the loader reads manifests with it, and the renderer finds the values that it may ignore
// in it.
//
// Sources: d3d9types.h for names and numbers; "Effect States (Direct3D 9)" in Microsoft's documentation for
// the names that only effect files have.
#pragma once

#include <permgen/states.h>

#include <cstddef>
#include <iterator>
#include <span>
#include <string_view>

#include "d3d9/values.h"

namespace permgen::d3d9 {

enum class Scope : std::uint8_t {
    Pass,         ///< CullMode = NONE
    PassIndexed,  ///< ColorOp[0] = MODULATE, in a pass only
    Sampler,      ///< MinFilter = LINEAR in a sampler_state, MinFilter[0] = LINEAR in a pass
};

enum class Support : std::uint8_t {
    Mapped,  ///< the renderer implements the state
    Fixed,   ///< every draw has the value StateRow::fixed; the renderer refuses any other
    None,    ///< no effect: part of the fixed-function pipeline, or of a disabled feature
};

struct StateRow {
    StateId id;
    std::string_view name;
    Scope scope;
    ValueKind kind;
    std::span<const NamedValue> values;
    Support support;
    std::uint32_t fixed = 0;  ///< of Support::Fixed
};

/// In StateId's order, from the first after Unknown.
inline constexpr StateRow states[] = {
    // Render states (D3DRENDERSTATETYPE).
    {StateId::ZEnable, "ZEnable", Scope::Pass, ValueKind::Enum, values::depth, Support::Mapped},
    {StateId::FillMode, "FillMode", Scope::Pass, ValueKind::Enum, values::fill, Support::Mapped},
    {StateId::ShadeMode, "ShadeMode", Scope::Pass, ValueKind::Enum, values::shade, Support::Fixed, 2u},
    {StateId::ZWriteEnable, "ZWriteEnable", Scope::Pass, ValueKind::Bool, values::switches, Support::Mapped},
    {StateId::AlphaTestEnable, "AlphaTestEnable", Scope::Pass, ValueKind::Bool, values::switches, Support::Fixed, 0u},
    {StateId::LastPixel, "LastPixel", Scope::Pass, ValueKind::Bool, values::switches, Support::None},
    {StateId::SrcBlend, "SrcBlend", Scope::Pass, ValueKind::Enum, values::blend, Support::Mapped},
    {StateId::DestBlend, "DestBlend", Scope::Pass, ValueKind::Enum, values::blend, Support::Mapped},
    {StateId::CullMode, "CullMode", Scope::Pass, ValueKind::Enum, values::cull, Support::Mapped},
    {StateId::ZFunc, "ZFunc", Scope::Pass, ValueKind::Enum, values::compare, Support::Mapped},
    {StateId::AlphaRef, "AlphaRef", Scope::Pass, ValueKind::Integer, {}, Support::None},
    {StateId::AlphaFunc, "AlphaFunc", Scope::Pass, ValueKind::Enum, values::compare, Support::None},
    {StateId::DitherEnable, "DitherEnable", Scope::Pass, ValueKind::Bool, values::switches, Support::None},
    {StateId::AlphaBlendEnable, "AlphaBlendEnable", Scope::Pass, ValueKind::Bool, values::switches, Support::Mapped},
    {StateId::FogEnable, "FogEnable", Scope::Pass, ValueKind::Bool, values::switches, Support::Fixed, 0u},
    {StateId::SpecularEnable, "SpecularEnable", Scope::Pass, ValueKind::Bool, values::switches, Support::Fixed, 0u},
    {StateId::FogColor, "FogColor", Scope::Pass, ValueKind::Colour, {}, Support::None},
    {StateId::FogTableMode, "FogTableMode", Scope::Pass, ValueKind::Enum, values::fog, Support::None},
    {StateId::FogStart, "FogStart", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::FogEnd, "FogEnd", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::FogDensity, "FogDensity", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::RangeFogEnable, "RangeFogEnable", Scope::Pass, ValueKind::Bool, values::switches, Support::None},
    {StateId::StencilEnable, "StencilEnable", Scope::Pass, ValueKind::Bool, values::switches, Support::Fixed, 0u},
    {StateId::StencilFail, "StencilFail", Scope::Pass, ValueKind::Enum, values::stencil_ops, Support::None},
    {StateId::StencilZFail, "StencilZFail", Scope::Pass, ValueKind::Enum, values::stencil_ops, Support::None},
    {StateId::StencilPass, "StencilPass", Scope::Pass, ValueKind::Enum, values::stencil_ops, Support::None},
    {StateId::StencilFunc, "StencilFunc", Scope::Pass, ValueKind::Enum, values::compare, Support::None},
    {StateId::StencilRef, "StencilRef", Scope::Pass, ValueKind::Integer, {}, Support::None},
    {StateId::StencilMask, "StencilMask", Scope::Pass, ValueKind::Integer, {}, Support::None},
    {StateId::StencilWriteMask, "StencilWriteMask", Scope::Pass, ValueKind::Integer, {}, Support::None},
    {StateId::TextureFactor, "TextureFactor", Scope::Pass, ValueKind::Colour, {}, Support::None},
    {StateId::Wrap0, "Wrap0", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap1, "Wrap1", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap2, "Wrap2", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap3, "Wrap3", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap4, "Wrap4", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap5, "Wrap5", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap6, "Wrap6", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap7, "Wrap7", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap8, "Wrap8", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap9, "Wrap9", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap10, "Wrap10", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap11, "Wrap11", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap12, "Wrap12", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap13, "Wrap13", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap14, "Wrap14", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Wrap15, "Wrap15", Scope::Pass, ValueKind::Flags, values::wraps, Support::Fixed, 0u},
    {StateId::Clipping, "Clipping", Scope::Pass, ValueKind::Bool, values::switches, Support::None},
    {StateId::Lighting, "Lighting", Scope::Pass, ValueKind::Bool, values::switches, Support::Fixed, 0u},
    {StateId::Ambient, "Ambient", Scope::Pass, ValueKind::Colour, {}, Support::None},
    {StateId::FogVertexMode, "FogVertexMode", Scope::Pass, ValueKind::Enum, values::fog, Support::None},
    {StateId::ColorVertex, "ColorVertex", Scope::Pass, ValueKind::Bool, values::switches, Support::None},
    {StateId::LocalViewer, "LocalViewer", Scope::Pass, ValueKind::Bool, values::switches, Support::None},
    {StateId::NormalizeNormals, "NormalizeNormals", Scope::Pass, ValueKind::Bool, values::switches, Support::None},
    {StateId::DiffuseMaterialSource, "DiffuseMaterialSource", Scope::Pass, ValueKind::Enum, values::material_source,
     Support::None},
    {StateId::SpecularMaterialSource, "SpecularMaterialSource", Scope::Pass, ValueKind::Enum, values::material_source,
     Support::None},
    {StateId::AmbientMaterialSource, "AmbientMaterialSource", Scope::Pass, ValueKind::Enum, values::material_source,
     Support::None},
    {StateId::EmissiveMaterialSource, "EmissiveMaterialSource", Scope::Pass, ValueKind::Enum, values::material_source,
     Support::None},
    {StateId::VertexBlend, "VertexBlend", Scope::Pass, ValueKind::Enum, values::vertex_blend, Support::None},
    {StateId::ClipPlaneEnable, "ClipPlaneEnable", Scope::Pass, ValueKind::Flags, values::clip_planes, Support::Fixed,
     0u},
    {StateId::PointSize, "PointSize", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::PointSize_Min, "PointSize_Min", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::PointSize_Max, "PointSize_Max", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::PointSpriteEnable, "PointSpriteEnable", Scope::Pass, ValueKind::Bool, values::switches, Support::None},
    {StateId::PointScaleEnable, "PointScaleEnable", Scope::Pass, ValueKind::Bool, values::switches, Support::None},
    {StateId::PointScale_A, "PointScale_A", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::PointScale_B, "PointScale_B", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::PointScale_C, "PointScale_C", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::MultiSampleAntialias, "MultiSampleAntialias", Scope::Pass, ValueKind::Bool, values::switches,
     Support::None},
    {StateId::MultiSampleMask, "MultiSampleMask", Scope::Pass, ValueKind::Integer, {}, Support::Fixed, 4294967295u},
    {StateId::PatchEdgeStyle, "PatchEdgeStyle", Scope::Pass, ValueKind::Enum, values::patch_edge, Support::None},
    {StateId::DebugMonitorToken, "DebugMonitorToken", Scope::Pass, ValueKind::Enum, values::debug_token, Support::None},
    {StateId::IndexedVertexBlendEnable, "IndexedVertexBlendEnable", Scope::Pass, ValueKind::Bool, values::switches,
     Support::None},
    {StateId::ColorWriteEnable, "ColorWriteEnable", Scope::Pass, ValueKind::Flags, values::channels, Support::Mapped},
    {StateId::TweenFactor, "TweenFactor", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::BlendOp, "BlendOp", Scope::Pass, ValueKind::Enum, values::blend_ops, Support::Mapped},
    {StateId::PositionDegree, "PositionDegree", Scope::Pass, ValueKind::Enum, values::degree, Support::None},
    {StateId::NormalDegree, "NormalDegree", Scope::Pass, ValueKind::Enum, values::degree, Support::None},
    {StateId::ScissorTestEnable, "ScissorTestEnable", Scope::Pass, ValueKind::Bool, values::switches, Support::Fixed,
     0u},
    {StateId::SlopeScaleDepthBias, "SlopeScaleDepthBias", Scope::Pass, ValueKind::Float, {}, Support::Fixed, 0u},
    {StateId::AntialiasedLineEnable, "AntialiasedLineEnable", Scope::Pass, ValueKind::Bool, values::switches,
     Support::None},
    {StateId::MinTessellationLevel, "MinTessellationLevel", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::MaxTessellationLevel, "MaxTessellationLevel", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::AdaptiveTess_X, "AdaptiveTess_X", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::AdaptiveTess_Y, "AdaptiveTess_Y", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::AdaptiveTess_Z, "AdaptiveTess_Z", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::AdaptiveTess_W, "AdaptiveTess_W", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::EnableAdaptiveTessellation, "EnableAdaptiveTessellation", Scope::Pass, ValueKind::Bool, values::switches,
     Support::None},
    {StateId::TwoSidedStencilMode, "TwoSidedStencilMode", Scope::Pass, ValueKind::Bool, values::switches,
     Support::None},
    {StateId::CCW_StencilFail, "CCW_StencilFail", Scope::Pass, ValueKind::Enum, values::stencil_ops, Support::None},
    {StateId::CCW_StencilZFail, "CCW_StencilZFail", Scope::Pass, ValueKind::Enum, values::stencil_ops, Support::None},
    {StateId::CCW_StencilPass, "CCW_StencilPass", Scope::Pass, ValueKind::Enum, values::stencil_ops, Support::None},
    {StateId::CCW_StencilFunc, "CCW_StencilFunc", Scope::Pass, ValueKind::Enum, values::compare, Support::None},
    {StateId::ColorWriteEnable1, "ColorWriteEnable1", Scope::Pass, ValueKind::Flags, values::channels, Support::None},
    {StateId::ColorWriteEnable2, "ColorWriteEnable2", Scope::Pass, ValueKind::Flags, values::channels, Support::None},
    {StateId::ColorWriteEnable3, "ColorWriteEnable3", Scope::Pass, ValueKind::Flags, values::channels, Support::None},
    {StateId::BlendFactor, "BlendFactor", Scope::Pass, ValueKind::Colour, {}, Support::None},
    {StateId::SRGBWriteEnable, "SRGBWriteEnable", Scope::Pass, ValueKind::Bool, values::switches, Support::Fixed, 0u},
    {StateId::DepthBias, "DepthBias", Scope::Pass, ValueKind::Float, {}, Support::Fixed, 0u},
    {StateId::SeparateAlphaBlendEnable, "SeparateAlphaBlendEnable", Scope::Pass, ValueKind::Bool, values::switches,
     Support::Mapped},
    {StateId::SrcBlendAlpha, "SrcBlendAlpha", Scope::Pass, ValueKind::Enum, values::blend, Support::Mapped},
    {StateId::DestBlendAlpha, "DestBlendAlpha", Scope::Pass, ValueKind::Enum, values::blend, Support::Mapped},
    {StateId::BlendOpAlpha, "BlendOpAlpha", Scope::Pass, ValueKind::Enum, values::blend_ops, Support::Mapped},
    // States that only effect files have.
    {StateId::VertexShader, "VertexShader", Scope::Pass, ValueKind::Object, {}, Support::Mapped},
    {StateId::PixelShader, "PixelShader", Scope::Pass, ValueKind::Object, {}, Support::Mapped},
    {StateId::NPatchMode, "NPatchMode", Scope::Pass, ValueKind::Float, {}, Support::None},
    {StateId::FVF, "FVF", Scope::Pass, ValueKind::Object, {}, Support::None},
    {StateId::ProjectionTransform, "ProjectionTransform", Scope::Pass, ValueKind::Object, {}, Support::None},
    {StateId::ViewTransform, "ViewTransform", Scope::Pass, ValueKind::Object, {}, Support::None},
    // The same, with an index.
    {StateId::WorldTransform, "WorldTransform", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::TextureTransform, "TextureTransform", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::LightType, "LightType", Scope::PassIndexed, ValueKind::Enum, values::lights, Support::None},
    {StateId::LightDiffuse, "LightDiffuse", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::LightSpecular, "LightSpecular", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::LightAmbient, "LightAmbient", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::LightPosition, "LightPosition", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::LightDirection, "LightDirection", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::LightRange, "LightRange", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::LightFalloff, "LightFalloff", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::LightAttenuation0, "LightAttenuation0", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::LightAttenuation1, "LightAttenuation1", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::LightAttenuation2, "LightAttenuation2", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::LightTheta, "LightTheta", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::LightPhi, "LightPhi", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::LightEnable, "LightEnable", Scope::PassIndexed, ValueKind::Bool, values::switches, Support::None},
    {StateId::Sampler, "Sampler", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::VertexShaderConstant, "VertexShaderConstant", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::VertexShaderConstant1, "VertexShaderConstant1", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::VertexShaderConstant2, "VertexShaderConstant2", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::VertexShaderConstant3, "VertexShaderConstant3", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::VertexShaderConstant4, "VertexShaderConstant4", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::VertexShaderConstantB, "VertexShaderConstantB", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::VertexShaderConstantI, "VertexShaderConstantI", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::VertexShaderConstantF, "VertexShaderConstantF", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::PixelShaderConstant, "PixelShaderConstant", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::PixelShaderConstant1, "PixelShaderConstant1", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::PixelShaderConstant2, "PixelShaderConstant2", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::PixelShaderConstant3, "PixelShaderConstant3", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::PixelShaderConstant4, "PixelShaderConstant4", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::PixelShaderConstantB, "PixelShaderConstantB", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::PixelShaderConstantI, "PixelShaderConstantI", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    {StateId::PixelShaderConstantF, "PixelShaderConstantF", Scope::PassIndexed, ValueKind::Object, {}, Support::None},
    // The material of the fixed-function pipeline.
    {StateId::MaterialDiffuse, "MaterialDiffuse", Scope::Pass, ValueKind::Object, {}, Support::None},
    {StateId::MaterialAmbient, "MaterialAmbient", Scope::Pass, ValueKind::Object, {}, Support::None},
    {StateId::MaterialSpecular, "MaterialSpecular", Scope::Pass, ValueKind::Object, {}, Support::None},
    {StateId::MaterialEmissive, "MaterialEmissive", Scope::Pass, ValueKind::Object, {}, Support::None},
    {StateId::MaterialPower, "MaterialPower", Scope::Pass, ValueKind::Float, {}, Support::None},
    // Texture stages (D3DTEXTURESTAGESTATETYPE).
    {StateId::ColorOp, "ColorOp", Scope::PassIndexed, ValueKind::Enum, values::texture_ops, Support::None},
    {StateId::ColorArg0, "ColorArg0", Scope::PassIndexed, ValueKind::Flags, values::texture_arguments, Support::None},
    {StateId::ColorArg1, "ColorArg1", Scope::PassIndexed, ValueKind::Flags, values::texture_arguments, Support::None},
    {StateId::ColorArg2, "ColorArg2", Scope::PassIndexed, ValueKind::Flags, values::texture_arguments, Support::None},
    {StateId::AlphaOp, "AlphaOp", Scope::PassIndexed, ValueKind::Enum, values::texture_ops, Support::None},
    {StateId::AlphaArg0, "AlphaArg0", Scope::PassIndexed, ValueKind::Flags, values::texture_arguments, Support::None},
    {StateId::AlphaArg1, "AlphaArg1", Scope::PassIndexed, ValueKind::Flags, values::texture_arguments, Support::None},
    {StateId::AlphaArg2, "AlphaArg2", Scope::PassIndexed, ValueKind::Flags, values::texture_arguments, Support::None},
    {StateId::ResultArg, "ResultArg", Scope::PassIndexed, ValueKind::Flags, values::texture_arguments, Support::None},
    {StateId::BumpEnvMat00, "BumpEnvMat00", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::BumpEnvMat01, "BumpEnvMat01", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::BumpEnvMat10, "BumpEnvMat10", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::BumpEnvMat11, "BumpEnvMat11", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::TexCoordIndex, "TexCoordIndex", Scope::PassIndexed, ValueKind::Flags, values::coordinates, Support::None},
    {StateId::BumpEnvLScale, "BumpEnvLScale", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::BumpEnvLOffset, "BumpEnvLOffset", Scope::PassIndexed, ValueKind::Float, {}, Support::None},
    {StateId::TextureTransformFlags, "TextureTransformFlags", Scope::PassIndexed, ValueKind::Flags,
     values::coordinate_transforms, Support::None},
    {StateId::Constant, "Constant", Scope::PassIndexed, ValueKind::Colour, {}, Support::None},
    // Samplers (D3DSAMPLERSTATETYPE): in a sampler_state, or in a pass with the sampler's index.
    {StateId::Texture, "Texture", Scope::Sampler, ValueKind::Object, {}, Support::Mapped},
    {StateId::AddressU, "AddressU", Scope::Sampler, ValueKind::Enum, values::addresses, Support::Mapped},
    {StateId::AddressV, "AddressV", Scope::Sampler, ValueKind::Enum, values::addresses, Support::Mapped},
    {StateId::AddressW, "AddressW", Scope::Sampler, ValueKind::Enum, values::addresses, Support::Mapped},
    {StateId::BorderColor, "BorderColor", Scope::Sampler, ValueKind::Colour, {}, Support::Fixed, 0u},
    {StateId::MagFilter, "MagFilter", Scope::Sampler, ValueKind::Enum, values::min_mag_filters, Support::Mapped},
    {StateId::MinFilter, "MinFilter", Scope::Sampler, ValueKind::Enum, values::min_mag_filters, Support::Mapped},
    {StateId::MipFilter, "MipFilter", Scope::Sampler, ValueKind::Enum, values::mip_filters, Support::Mapped},
    {StateId::MipMapLodBias, "MipMapLodBias", Scope::Sampler, ValueKind::Float, {}, Support::Fixed, 0u},
    {StateId::MaxMipLevel, "MaxMipLevel", Scope::Sampler, ValueKind::Integer, {}, Support::Fixed, 0u},
    {StateId::MaxAnisotropy, "MaxAnisotropy", Scope::Sampler, ValueKind::Integer, {}, Support::None},
    {StateId::SRGBTexture, "SRGBTexture", Scope::Sampler, ValueKind::Bool, values::switches, Support::Fixed, 0u},
    {StateId::ElementIndex, "ElementIndex", Scope::Sampler, ValueKind::Integer, {}, Support::None},
    {StateId::DMapOffset, "DMapOffset", Scope::Sampler, ValueKind::Integer, {}, Support::None},
};

constexpr bool same_word(std::string_view a, std::string_view b) {
    const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; };
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (upper(a[i]) != upper(b[i])) return false;
    return true;
}

/// Null if Direct3D 9 has no state of that name. Letter case does not matter.
constexpr const StateRow* find_state(std::string_view name) {
    for (const StateRow& row : states)
        if (same_word(row.name, name)) return &row;
    return nullptr;
}

/// `id` must not be Unknown.
constexpr const StateRow& row_of(StateId id) {
    return states[static_cast<std::size_t>(id) - 1];
}

/// Null if the state has no value of that name. Letter case does not matter.
constexpr const NamedValue* find_value(const StateRow& row, std::string_view name) {
    for (const NamedValue& value : row.values)
        if (same_word(value.name, name)) return &value;
    return nullptr;
}

/// Null if the state has no named value of that number.
constexpr const NamedValue* find_value(const StateRow& row, std::uint32_t bits) {
    for (const NamedValue& value : row.values)
        if (value.bits == bits) return &value;
    return nullptr;
}

/// All named bits of a Flags state together.
constexpr std::uint32_t all_bits(const StateRow& row) {
    std::uint32_t bits = 0;
    for (const NamedValue& value : row.values) bits |= value.bits;
    return bits;
}

constexpr bool table_is_in_order() {
    for (std::size_t i = 0; i < std::size(states); ++i)
        if (static_cast<std::size_t>(states[i].id) != i + 1) return false;
    return true;
}
static_assert(table_is_in_order());

}  // namespace permgen::d3d9

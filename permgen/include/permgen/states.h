// Direct3D 9's states as enums and numbers: the settings of a pass or a sampler, without string comparisons. Plain
// data, no dependencies. Values are Direct3D 9's own numbers (d3d9types.h).
#pragma once

#include <cstdint>

namespace permgen {

/// A state, by its name in effect files.
enum class StateId : std::uint16_t {
    Unknown,  ///< a State without an id

    // Render states (D3DRENDERSTATETYPE).
    ZEnable,
    FillMode,
    ShadeMode,
    ZWriteEnable,
    AlphaTestEnable,
    LastPixel,
    SrcBlend,
    DestBlend,
    CullMode,
    ZFunc,
    AlphaRef,
    AlphaFunc,
    DitherEnable,
    AlphaBlendEnable,
    FogEnable,
    SpecularEnable,
    FogColor,
    FogTableMode,
    FogStart,
    FogEnd,
    FogDensity,
    RangeFogEnable,
    StencilEnable,
    StencilFail,
    StencilZFail,
    StencilPass,
    StencilFunc,
    StencilRef,
    StencilMask,
    StencilWriteMask,
    TextureFactor,
    Wrap0,
    Wrap1,
    Wrap2,
    Wrap3,
    Wrap4,
    Wrap5,
    Wrap6,
    Wrap7,
    Wrap8,
    Wrap9,
    Wrap10,
    Wrap11,
    Wrap12,
    Wrap13,
    Wrap14,
    Wrap15,
    Clipping,
    Lighting,
    Ambient,
    FogVertexMode,
    ColorVertex,
    LocalViewer,
    NormalizeNormals,
    DiffuseMaterialSource,
    SpecularMaterialSource,
    AmbientMaterialSource,
    EmissiveMaterialSource,
    VertexBlend,
    ClipPlaneEnable,
    PointSize,
    PointSize_Min,
    PointSize_Max,
    PointSpriteEnable,
    PointScaleEnable,
    PointScale_A,
    PointScale_B,
    PointScale_C,
    MultiSampleAntialias,
    MultiSampleMask,
    PatchEdgeStyle,
    DebugMonitorToken,
    IndexedVertexBlendEnable,
    ColorWriteEnable,
    TweenFactor,
    BlendOp,
    PositionDegree,
    NormalDegree,
    ScissorTestEnable,
    SlopeScaleDepthBias,
    AntialiasedLineEnable,
    MinTessellationLevel,
    MaxTessellationLevel,
    AdaptiveTess_X,
    AdaptiveTess_Y,
    AdaptiveTess_Z,
    AdaptiveTess_W,
    EnableAdaptiveTessellation,
    TwoSidedStencilMode,
    CCW_StencilFail,
    CCW_StencilZFail,
    CCW_StencilPass,
    CCW_StencilFunc,
    ColorWriteEnable1,
    ColorWriteEnable2,
    ColorWriteEnable3,
    BlendFactor,
    SRGBWriteEnable,
    DepthBias,
    SeparateAlphaBlendEnable,
    SrcBlendAlpha,
    DestBlendAlpha,
    BlendOpAlpha,

    // States that only effect files have.
    VertexShader,
    PixelShader,
    NPatchMode,
    FVF,
    ProjectionTransform,
    ViewTransform,

    // The same, with an index.
    WorldTransform,
    TextureTransform,
    LightType,
    LightDiffuse,
    LightSpecular,
    LightAmbient,
    LightPosition,
    LightDirection,
    LightRange,
    LightFalloff,
    LightAttenuation0,
    LightAttenuation1,
    LightAttenuation2,
    LightTheta,
    LightPhi,
    LightEnable,
    Sampler,
    VertexShaderConstant,
    VertexShaderConstant1,
    VertexShaderConstant2,
    VertexShaderConstant3,
    VertexShaderConstant4,
    VertexShaderConstantB,
    VertexShaderConstantI,
    VertexShaderConstantF,
    PixelShaderConstant,
    PixelShaderConstant1,
    PixelShaderConstant2,
    PixelShaderConstant3,
    PixelShaderConstant4,
    PixelShaderConstantB,
    PixelShaderConstantI,
    PixelShaderConstantF,

    // The material of the fixed-function pipeline.
    MaterialDiffuse,
    MaterialAmbient,
    MaterialSpecular,
    MaterialEmissive,
    MaterialPower,

    // Texture stages (D3DTEXTURESTAGESTATETYPE).
    ColorOp,
    ColorArg0,
    ColorArg1,
    ColorArg2,
    AlphaOp,
    AlphaArg0,
    AlphaArg1,
    AlphaArg2,
    ResultArg,
    BumpEnvMat00,
    BumpEnvMat01,
    BumpEnvMat10,
    BumpEnvMat11,
    TexCoordIndex,
    BumpEnvLScale,
    BumpEnvLOffset,
    TextureTransformFlags,
    Constant,

    // Samplers (D3DSAMPLERSTATETYPE): in a sampler_state, or in a pass with the sampler's index.
    Texture,
    AddressU,
    AddressV,
    AddressW,
    BorderColor,
    MagFilter,
    MinFilter,
    MipFilter,
    MipMapLodBias,
    MaxMipLevel,
    MaxAnisotropy,
    SRGBTexture,
    ElementIndex,
    DMapOffset,
};

/// What State::bits holds.
enum class ValueKind : std::uint8_t {
    Words,       ///< nothing: the value is only in the author's words
    Bool,        ///< 0 or 1
    Enum,        ///< one of the state's named values
    Integer,     ///< a DWORD
    Float,       ///< IEEE 754 binary32
    Flags,       ///< named bits, joined
    Colour,      ///< 0xAARRGGBB, a D3DCOLOR
    Object,      ///< nothing: a texture, a vector or a matrix
    Expression,  ///< nothing: depends on parameters; permgen does not compute it
};

/// D3DBLEND: SrcBlend, DestBlend, SrcBlendAlpha, DestBlendAlpha.
enum class Blend : std::uint32_t {
    Zero = 1,
    One,
    SrcColor,
    InvSrcColor,
    SrcAlpha,
    InvSrcAlpha,
    DestAlpha,
    InvDestAlpha,
    DestColor,
    InvDestColor,
    SrcAlphaSat,
};

/// D3DBLENDOP: BlendOp, BlendOpAlpha.
enum class BlendOp : std::uint32_t { Add = 1, Subtract, RevSubtract, Min, Max };

/// D3DCMPFUNC: ZFunc.
enum class Compare : std::uint32_t { Never = 1, Less, Equal, LessEqual, Greater, NotEqual, GreaterEqual, Always };

/// D3DCULL: CullMode names the winding that is culled.
enum class Cull : std::uint32_t { None = 1, Cw, Ccw };

/// D3DTEXTUREFILTERTYPE: MinFilter, MagFilter, MipFilter.
enum class Filter : std::uint32_t { None, Point, Linear };

/// D3DTEXTUREADDRESS: AddressU, AddressV, AddressW.
enum class Address : std::uint32_t { Wrap = 1, Mirror, Clamp, Border };

}  // namespace permgen

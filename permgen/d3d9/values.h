// The named values that Direct3D 9's states take in effect files, with d3d9types.h's numbers.
#pragma once

#include <cstdint>
#include <string_view>

namespace permgen::d3d9 {

struct NamedValue {
    std::string_view name;  ///< upper case; effect files may use any case
    std::uint32_t bits;
    bool drawn = true;  ///< false: Vulkan or the renderer does not support it
};

namespace values {

inline constexpr NamedValue switches[] = {{"FALSE", 0}, {"TRUE", 1}};

/// D3DBLEND
inline constexpr NamedValue blend[] = {{"ZERO", 1},
                                       {"ONE", 2},
                                       {"SRCCOLOR", 3},
                                       {"INVSRCCOLOR", 4},
                                       {"SRCALPHA", 5},
                                       {"INVSRCALPHA", 6},
                                       {"DESTALPHA", 7},
                                       {"INVDESTALPHA", 8},
                                       {"DESTCOLOR", 9},
                                       {"INVDESTCOLOR", 10},
                                       {"SRCALPHASAT", 11},
                                       {"BOTHSRCALPHA", 12, false},
                                       {"BOTHINVSRCALPHA", 13, false},
                                       {"BLENDFACTOR", 14, false},
                                       {"INVBLENDFACTOR", 15, false},
                                       {"SRCCOLOR2", 16, false},
                                       {"INVSRCCOLOR2", 17, false}};

/// D3DBLENDOP
inline constexpr NamedValue blend_ops[] = {{"ADD", 1}, {"SUBTRACT", 2}, {"REVSUBTRACT", 3}, {"MIN", 4}, {"MAX", 5}};

/// D3DCMPFUNC
inline constexpr NamedValue compare[] = {{"NEVER", 1},   {"LESS", 2},     {"EQUAL", 3},        {"LESSEQUAL", 4},
                                         {"GREATER", 5}, {"NOTEQUAL", 6}, {"GREATEREQUAL", 7}, {"ALWAYS", 8}};

/// D3DCULL
inline constexpr NamedValue cull[] = {{"NONE", 1}, {"CW", 2}, {"CCW", 3}};

/// D3DZBUFFERTYPE
inline constexpr NamedValue depth[] = {{"FALSE", 0}, {"TRUE", 1}, {"USEW", 2, false}};

/// D3DFILLMODE
inline constexpr NamedValue fill[] = {{"POINT", 1, false}, {"WIREFRAME", 2, false}, {"SOLID", 3}};

/// D3DSHADEMODE
inline constexpr NamedValue shade[] = {{"FLAT", 1}, {"GOURAUD", 2}, {"PHONG", 3}};

/// D3DSTENCILOP
inline constexpr NamedValue stencil_ops[] = {{"KEEP", 1},    {"ZERO", 2},   {"REPLACE", 3}, {"INCRSAT", 4},
                                             {"DECRSAT", 5}, {"INVERT", 6}, {"INCR", 7},    {"DECR", 8}};

/// D3DFOGMODE
inline constexpr NamedValue fog[] = {{"NONE", 0}, {"EXP", 1}, {"EXP2", 2}, {"LINEAR", 3}};

/// D3DMATERIALCOLORSOURCE
inline constexpr NamedValue material_source[] = {{"MATERIAL", 0}, {"COLOR1", 1}, {"COLOR2", 2}};

/// D3DVERTEXBLENDFLAGS
inline constexpr NamedValue vertex_blend[] = {{"DISABLE", 0},  {"1WEIGHTS", 1},    {"2WEIGHTS", 2},
                                              {"3WEIGHTS", 3}, {"TWEENING", 255u}, {"0WEIGHTS", 256u}};

/// D3DPATCHEDGESTYLE
inline constexpr NamedValue patch_edge[] = {{"DISCRETE", 0}, {"CONTINUOUS", 1}};

/// D3DDEBUGMONITORTOKENS
inline constexpr NamedValue debug_token[] = {{"ENABLE", 0}, {"DISABLE", 1}};

/// D3DDEGREETYPE
inline constexpr NamedValue degree[] = {{"LINEAR", 1}, {"QUADRATIC", 2}, {"CUBIC", 3}, {"QUINTIC", 5}};

/// D3DTEXTUREOP
inline constexpr NamedValue texture_ops[] = {{"DISABLE", 1},
                                             {"SELECTARG1", 2},
                                             {"SELECTARG2", 3},
                                             {"MODULATE", 4},
                                             {"MODULATE2X", 5},
                                             {"MODULATE4X", 6},
                                             {"ADD", 7},
                                             {"ADDSIGNED", 8},
                                             {"ADDSIGNED2X", 9},
                                             {"SUBTRACT", 10},
                                             {"ADDSMOOTH", 11},
                                             {"BLENDDIFFUSEALPHA", 12},
                                             {"BLENDTEXTUREALPHA", 13},
                                             {"BLENDFACTORALPHA", 14},
                                             {"BLENDTEXTUREALPHAPM", 15},
                                             {"BLENDCURRENTALPHA", 16},
                                             {"PREMODULATE", 17},
                                             {"MODULATEALPHA_ADDCOLOR", 18},
                                             {"MODULATECOLOR_ADDALPHA", 19},
                                             {"MODULATEINVALPHA_ADDCOLOR", 20},
                                             {"MODULATEINVCOLOR_ADDALPHA", 21},
                                             {"BUMPENVMAP", 22},
                                             {"BUMPENVMAPLUMINANCE", 23},
                                             {"DOTPRODUCT3", 24},
                                             {"MULTIPLYADD", 25},
                                             {"LERP", 26}};

/// D3DTEXTUREFILTERTYPE
inline constexpr NamedValue min_mag_filters[] = {{"NONE", 0, false},
                                                 {"POINT", 1},
                                                 {"LINEAR", 2},
                                                 {"ANISOTROPIC", 3, false},
                                                 {"PYRAMIDALQUAD", 6, false},
                                                 {"GAUSSIANQUAD", 7, false},
                                                 {"CONVOLUTIONMONO", 8, false}};

/// D3DTEXTUREFILTERTYPE, between mip levels
inline constexpr NamedValue mip_filters[] = {{"NONE", 0}, {"POINT", 1}, {"LINEAR", 2}, {"ANISOTROPIC", 3, false}};

/// D3DTEXTUREADDRESS
inline constexpr NamedValue addresses[] = {
    {"WRAP", 1}, {"MIRROR", 2}, {"CLAMP", 3}, {"BORDER", 4}, {"MIRRORONCE", 5, false}};

/// D3DLIGHTTYPE
inline constexpr NamedValue lights[] = {{"POINT", 1}, {"SPOT", 2}, {"DIRECTIONAL", 3}};

/// D3DCOLORWRITEENABLE
inline constexpr NamedValue channels[] = {{"RED", 1}, {"GREEN", 2}, {"BLUE", 4}, {"ALPHA", 8}};

/// D3DTA
inline constexpr NamedValue texture_arguments[] = {{"DIFFUSE", 0},  {"CURRENT", 1},     {"TEXTURE", 2},
                                                   {"TFACTOR", 3},  {"SPECULAR", 4},    {"TEMP", 5},
                                                   {"CONSTANT", 6}, {"COMPLEMENT", 16}, {"ALPHAREPLICATE", 32}};

/// D3DTSS_TCI
inline constexpr NamedValue coordinates[] = {{"PASSTHRU", 0},
                                             {"CAMERASPACENORMAL", 65536u},
                                             {"CAMERASPACEPOSITION", 131072u},
                                             {"CAMERASPACEREFLECTIONVECTOR", 196608u},
                                             {"SPHEREMAP", 262144u}};

/// D3DTEXTURETRANSFORMFLAGS
inline constexpr NamedValue coordinate_transforms[] = {{"DISABLE", 0}, {"COUNT1", 1}, {"COUNT2", 2},
                                                       {"COUNT3", 3},  {"COUNT4", 4}, {"PROJECTED", 256u}};

/// D3DWRAPCOORD
inline constexpr NamedValue wraps[] = {{"U", 1},       {"V", 2},       {"W", 4},      {"COORD_0", 1},
                                       {"COORD_1", 2}, {"COORD_2", 4}, {"COORD_3", 8}};

/// D3DCLIPPLANE
inline constexpr NamedValue clip_planes[] = {{"CLIPPLANE0", 1}, {"CLIPPLANE1", 2},  {"CLIPPLANE2", 4},
                                             {"CLIPPLANE3", 8}, {"CLIPPLANE4", 16}, {"CLIPPLANE5", 32}};

}  // namespace values
}  // namespace permgen::d3d9

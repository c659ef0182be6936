// An effect after lowering: HLSL for glslang, and the interface that the result must have. The boundary between the
// effect language (preprocess, lex, parse, lower) and the back end (compile, specialize, reflect, emit): plain data
// that uses no types of either side.
#pragma once

#include <permgen/tables.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "front/diagnostic.h"

namespace permgen {

/// A specialization constant that the generated wrapper declares.
struct LoweredAxis {
    std::string name;  ///< the author's parameter name
    std::uint32_t id;  ///< constant_id, from 0 in parameter order
    ScalarType type;
    std::uint32_t default_bits;  ///< the parameter's default value if it has one, else 0
    SourceLocation place;
};

/// One input or output of an entry point, after semantics were resolved.
struct LoweredAttribute {
    std::string semantic;  ///< upper case with index: "TEXCOORD3", "COLOR0", "SV_POSITION", "SV_CLIPDISTANCE1"
    bool builtin = false;  ///< a system value: has no location
    std::uint32_t location = 0;
    std::uint32_t components = 4;
    ScalarType type = ScalarType::Float;
    SourceLocation place;
};

/// A state that a pass or a sampler sets.
struct LoweredState {
    std::string name;   ///< Direct3D 9's spelling: "MinFilter", "ColorOp[0]"
    std::string value;  ///< the author's words
    StateId id = StateId::Unknown;
    std::uint32_t index = 0;  ///< for states such as ColorOp[0]
    ValueKind kind = ValueKind::Words;
    std::uint32_t bits = 0;
};

struct LoweredResource {
    std::string name;
    ResourceKind kind;
    ImageDimension dimension = ImageDimension::None;
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
    std::vector<LoweredState> sampler_states;
    ImageFormat format = ImageFormat::None;
    bool writable = false;
    SourceLocation place;
};

/// One entry point to compile. Techniques with equal entries share one.
struct LoweredModule {
    std::string name;          ///< unique in the effect
    std::string entry;         ///< the generated wrapper's name: the SPIR-V's entry point
    std::string author_entry;  ///< "ps_main"
    Stage stage;
    std::array<std::uint32_t, 3> group_size{};  ///< of a compute shader
    std::string profile;                        ///< "ps_3_0", as written
    std::string hlsl;
    std::vector<SourceLocation> line_map;  ///< the author's place of each line of `hlsl`; an empty file means a
                                           ///< generated line
    std::vector<LoweredAxis> axes;
    std::vector<LoweredAttribute> inputs;
    std::vector<LoweredAttribute> outputs;
    SourceLocation place;  ///< of the entry function
};

struct LoweredConstant {
    std::string name;
    std::uint32_t id;
    ScalarType type;
    std::uint32_t bits;
};

struct LoweredShader {
    int module = -1;  ///< index into Lowered::modules; -1: the pass has no such stage
    std::vector<LoweredConstant> constants;
    SourceLocation place;  ///< of the `compile` expression
};

struct LoweredPass {
    std::string name;
    LoweredShader vertex;
    LoweredShader pixel;
    LoweredShader compute;
    std::vector<LoweredState> states;
    SourceLocation place;
};

struct LoweredTechnique {
    std::string name;
    std::vector<LoweredPass> passes;
    SourceLocation place;
};

struct Lowered {
    std::string name;  ///< file name without folder and extension
    std::vector<LoweredModule> modules;
    std::vector<LoweredResource> resources;  ///< of the whole effect, in order of binding
    std::vector<LoweredTechnique> techniques;
    std::vector<std::string> dependencies;  ///< every file that was read; the effect comes first
};

}  // namespace permgen

// A parsed effect file: its declarations, as plain data over the preprocessed tokens. Independent of SPIR-V and Vulkan.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "front/lex.h"

namespace permgen {

/// Indices into ParsedEffect::tokens, `end` not included.
struct TokenRange {
    std::size_t begin = 0;
    std::size_t end = 0;

    bool empty() const { return begin == end; }
    std::size_t size() const { return end - begin; }
};

/// A semantic in the form that HLSL compares: upper case, with a separate number. "TexCoord3" is {"TEXCOORD", 3}.
struct Semantic {
    std::string name;
    unsigned index = 0;
    bool centroid = false;  ///< written with D3D9's suffix, TEXCOORD3_centroid
    Location at;

    bool present() const { return !name.empty(); }
};

/// A type as written, without qualifiers: "float4", "vector<float,4>", "SliceVertex".
struct TypeName {
    std::string_view name;               ///< first word, e.g. "vector"
    std::vector<std::string> arguments;  ///< of vector<> and matrix<>, e.g. {"float", "4"}
    TokenRange range;
    Location at;
};

/// Words in front of a declaration's type.
struct Qualifiers {
    bool is_static = false;
    bool is_const = false;
    bool is_uniform = false;
    bool in = false;
    bool out = false;
    bool row_major = false;
    bool centroid = false;
    bool noperspective = false;
    bool nointerpolation = false;
    bool groupshared = false;
};

/// One declared name: a global, a member of a struct or cbuffer, or a parameter.
struct Variable {
    TypeName type;
    Qualifiers qualifiers;
    std::string_view name;
    Location at;
    std::vector<TokenRange> dimensions;  ///< the tokens between each pair of brackets
    Semantic semantic;
    TokenRange initializer;  ///< from '=' to ',' or ';', both excluded; empty: none
    TokenRange range;        ///< the whole declaration; declarators that share one type overlap in the type
};

struct Struct {
    std::string_view name;
    std::vector<Variable> members;
    TokenRange range;
    Location at;
};

/// `[numthreads(8, 8, 1)]`
struct ThreadGroup {
    std::vector<TokenRange> sizes;  ///< what stands between the commas
    Location at;
};

struct Function {
    std::string_view name;
    TypeName result;
    Semantic semantic;  ///< of the result
    std::vector<Variable> parameters;
    std::optional<ThreadGroup> threads;
    TokenRange body;  ///< with its braces; empty: a prototype
    TokenRange range;
    Location at;
};

struct StateAssignment {
    std::string name;   ///< "MinFilter", "ColorOp[0]"
    std::string value;  ///< single words in upper case, <name> and (name) without their brackets
    TokenRange index;   ///< the tokens between the brackets after the name
    TokenRange words;   ///< the value
    TokenRange range;
    Location at;
};

struct Sampler {
    std::string_view name;
    std::size_t type_token = 0;  ///< index of `sampler`, `sampler2D`, ...
    std::vector<StateAssignment> states;
    TokenRange range;
    Location at;
};

/// A D3D9 texture object, which a sampler's `Texture = <name>` names; SPIR-V does not need it.
struct TextureObject {
    std::string_view name;
    Location at;
};

/// `[[vk::image_format("rgba16f")]]`
struct ImageFormatAttribute {
    std::string_view name;  ///< without quotes
    Location at;            ///< of the name
};

/// A storage image or buffer, `RWTexture2D<float4> image;`
struct StorageResource {
    std::string_view type;  ///< one of d3d9::storage_types
    TypeName element;       ///< not of a byte address buffer
    std::optional<ImageFormatAttribute> format;
    std::string_view name;
    TokenRange range;
    Location at;
};

struct Typedef {
    std::string_view name;
    TypeName type;
    TokenRange range;
};

struct ConstantBuffer {
    std::string_view name;
    std::vector<Variable> members;
    std::size_t open_brace = 0;  ///< index of its '{'
    TokenRange range;
    Location at;
};

/// `compile PROFILE ENTRY(ARGUMENTS)`
struct Compile {
    std::string_view profile;
    std::string_view entry;
    std::vector<TokenRange> arguments;
    Location at;  ///< of `compile`
    Location entry_at;
};

struct ParsedPass {
    std::string name;
    std::optional<Compile> vertex;
    std::optional<Compile> pixel;
    std::optional<Compile> compute;
    std::vector<StateAssignment> states;
    Location at;
};

struct ParsedTechnique {
    std::string name;
    std::vector<ParsedPass> passes;
    Location at;
};

/// The declarations at file scope, in the author's order.
enum class ItemKind { Struct, Function, Globals, Sampler, Storage, Typedef, ConstantBuffer, Dropped };

struct Item {
    ItemKind kind;
    std::size_t index;  ///< into the vector of its kind; for Globals: the first one
    std::size_t count;  ///< number of declarations; always 1 except for Globals
    TokenRange range;
};

struct ParsedEffect {
    Tokens tokens;
    std::vector<bool> dropped;  ///< one for each token: true if the HLSL compiler must not see it
    std::vector<Item> items;
    std::vector<Struct> structs;
    std::vector<Function> functions;
    std::vector<Variable> globals;
    std::vector<Sampler> samplers;
    std::vector<TextureObject> textures;
    std::vector<StorageResource> storages;
    std::vector<Typedef> typedefs;
    std::vector<ConstantBuffer> constant_buffers;
    std::vector<ParsedTechnique> techniques;
};

}  // namespace permgen

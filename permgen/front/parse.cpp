#include "front/parse.h"

#include <algorithm>
#include <array>

#include "front/parse_declaration.h"
#include "front/parse_storage.h"
#include "front/parse_technique.h"

namespace permgen {
namespace {

constexpr std::size_t max_syntax_errors = 20;

// Words that begin unsupported constructs of D3D10, later HLSL or D3DX.
struct Refused {
    std::string_view word;
    std::string_view reason;
};
constexpr std::array<Refused, 37> refused_words = {{
    {"technique10", "write a `technique` with `compile`"},
    {"technique11", "write a `technique` with `compile`"},
    {"fxgroup", "write the techniques at file scope"},
    {"VertexShader", "write the `compile` into the pass"},
    {"PixelShader", "write the `compile` into the pass"},
    {"vertexshader", "write the `compile` into the pass"},
    {"ComputeShader", "write the `compile` into the pass"},
    {"pixelshader", "write the `compile` into the pass"},
    {"vertexfragment", "write the shader in HLSL and `compile` it"},
    {"pixelfragment", "write the shader in HLSL and `compile` it"},
    {"stateblock", "write the states into the pass"},
    {"asm", "write the shader in HLSL"},
    {"tbuffer", "use a cbuffer"},
    {"namespace", "prefix the names instead"},
    {"class", "use a struct and functions"},
    {"interface", "use a struct and functions"},
    {"SamplerState", "declare a `sampler2D` and read it with tex2D"},
    {"SamplerComparisonState", "declare a `sampler2D` and compare in the shader"},
    {"Texture1D", "declare a `sampler1D` and read it with tex1D"},
    {"Texture2D", "declare a `sampler2D` and read it with tex2D"},
    {"Texture3D", "declare a `sampler3D` and read it with tex3D"},
    {"TextureCube", "declare a `samplerCUBE` and read it with texCUBE"},
    {"Texture1DArray", "use a `sampler2D` or a `sampler3D`"},
    {"Texture2DArray", "use a `sampler3D`"},
    {"TextureCubeArray", "declare a `samplerCUBE` for each"},
    {"Texture2DMS", "resolve it, declare a `sampler2D` and read it with tex2D"},
    {"Buffer", "use a StructuredBuffer"},
    {"RWBuffer", "use a RWStructuredBuffer"},
    {"AppendStructuredBuffer", "use a RWStructuredBuffer and count with InterlockedAdd"},
    {"ConsumeStructuredBuffer", "use a RWStructuredBuffer and count with InterlockedAdd"},
    {"RWTexture1DArray", "use a RWTexture2D"},
    {"RWTexture2DArray", "use a RWTexture3D"},
    {"RasterizerOrderedTexture2D", "use a RWTexture2D in a compute shader"},
    {"RasterizerOrderedBuffer", "use a RWStructuredBuffer in a compute shader"},
    {"RasterizerOrderedStructuredBuffer", "use a RWStructuredBuffer in a compute shader"},
    {"RasterizerOrderedByteAddressBuffer", "use a RWByteAddressBuffer in a compute shader"},
    {"globallycoherent", "separate passes with a barrier instead"},
}};

// `texture` and `sampler` are types only in front of a name.
bool declares(const ParseCursor& cursor, bool (*is_type)(const Token&), std::size_t ahead) {
    return is_type(cursor.peek(ahead)) && cursor.peek(ahead + 1).is_identifier() && !cursor.peek(ahead + 2).is("(");
}

// A `string`: data for tools.
void drop_declaration(ParseCursor& cursor) {
    const std::size_t begin = cursor.at;
    cursor.take();
    do {
        Variable declarator;
        declarator.name = cursor.expect_identifier("a name").text;
        parse_declarator(cursor, declarator, ",;");
    } while (cursor.take_if(","));
    cursor.expect(";", "after this declaration");
    cursor.drop({begin, cursor.at});
}

std::size_t count_qualifiers(const ParseCursor& cursor) {
    static constexpr std::array<std::string_view, 5> skippable = {"uniform", "extern", "shared", "static", "const"};
    std::size_t qualifiers = 0;
    while (std::any_of(skippable.begin(), skippable.end(),
                       [&](std::string_view word) { return cursor.peek(qualifiers).is(word); }))
        ++qualifiers;
    return qualifiers;
}

void drop_next(ParseCursor& cursor, std::size_t tokens) {
    cursor.drop({cursor.at, cursor.at + tokens});
    cursor.at += tokens;
}

void refuse_word(ParseCursor& cursor) {
    const Token& token = cursor.peek();
    for (const Refused& refused : refused_words)
        if (token.is(refused.word) &&
            (cursor.peek(1).is_identifier() || cursor.peek(1).is("{") || cursor.peek(1).is("<")))
            cursor.fail("PG022", token.at,
                        "'" + std::string(token.text) + "' is not supported; " + std::string(refused.reason));
}

/// What follows `[[vk::image_format("...")]]`.
void parse_with_format(ParseCursor& cursor, const ImageFormatAttribute& format) {
    refuse_word(cursor);
    const std::size_t qualifiers = count_qualifiers(cursor);
    if (!begins_storage(cursor, qualifiers))
        cursor.fail("PG041", format.at,
                    "[[vk::image_format(...)]] belongs in front of a RWTexture1D, RWTexture2D or RWTexture3D; move it "
                    "there or remove it");
    drop_next(cursor, qualifiers);
    parse_storages(cursor, format);
}

void parse_item(ParseCursor& cursor) {
    const Token& token = cursor.peek();
    if (token.is(";")) return cursor.drop({cursor.at, (cursor.take(), cursor.at)});
    if (same_word(token.text, "technique")) return parse_technique(cursor);
    if (const auto format = parse_image_format(cursor)) return parse_with_format(cursor, *format);
    refuse_word(cursor);
    if (token.is("struct")) return parse_struct(cursor);
    if (token.is("typedef")) return parse_typedef(cursor);
    if (token.is("cbuffer")) return parse_constant_buffer(cursor);
    if (token.is("string") && cursor.peek(1).is_identifier()) return drop_declaration(cursor);

    const std::size_t qualifiers = count_qualifiers(cursor);
    if (declares(cursor, is_sampler_type, qualifiers)) return drop_next(cursor, qualifiers), parse_samplers(cursor);
    if (declares(cursor, is_texture_type, qualifiers)) return drop_next(cursor, qualifiers), parse_textures(cursor);
    if (begins_storage(cursor, qualifiers)) return drop_next(cursor, qualifiers), parse_storages(cursor, {});
    parse_function_or_globals(cursor);
}

// Skips from the beginning of an item with a syntax error to the probable beginning of the next item.
void resynchronize(ParseCursor& cursor) {
    std::size_t open = 0;
    cursor.take();
    while (!cursor.done()) {
        const Token& token = cursor.peek();
        const bool new_item = token.starts_line && token.at.column == 1 &&
                              (same_word(token.text, "technique") || token.is("struct") || token.is("cbuffer"));
        if (new_item) return;
        cursor.take();
        if (token.is("{")) ++open;
        if (token.is("}") && (open == 0 || --open == 0)) {
            cursor.take_if(";");
            return;
        }
        if (token.is(";") && open == 0) return;
    }
}

}  // namespace

ParsedEffect parse(Tokens tokens, const Sources& sources, Diagnostics& diagnostics) {
    ParsedEffect effect;
    effect.tokens = std::move(tokens);
    effect.dropped.assign(effect.tokens.size(), false);
    ParseCursor cursor{effect, sources, diagnostics};
    std::size_t errors = 0;
    while (!cursor.done() && errors < max_syntax_errors) {
        const std::size_t begin = cursor.at;
        try {
            parse_item(cursor);
        } catch (const SyntaxError&) {
            ++errors;
            cursor.at = begin;
            resynchronize(cursor);
        }
    }
    return effect;
}

Semantic parse_semantic(const Token& word) {
    Semantic semantic;
    semantic.at = word.at;
    std::string text(word.text);
    for (char& c : text)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    constexpr std::string_view centroid = "_CENTROID";
    if (text.size() > centroid.size() && text.ends_with(centroid)) {
        semantic.centroid = true;
        text.resize(text.size() - centroid.size());
    }
    std::size_t digits = text.size();
    while (digits > 0 && text[digits - 1] >= '0' && text[digits - 1] <= '9' && text.size() - digits < 4) --digits;
    for (std::size_t i = digits; i < text.size(); ++i)
        semantic.index = semantic.index * 10 + static_cast<unsigned>(text[i] - '0');
    semantic.name = text.substr(0, digits);
    return semantic;
}

}  // namespace permgen

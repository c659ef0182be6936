#include "front/parse_technique.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "common/nearest.h"
#include "d3d9/profiles.h"
#include "d3d9/states.h"
#include "front/parse_declaration.h"
#include "front/report.h"

namespace permgen {
namespace {

using d3d9::StageWords;

std::string upper(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

void check_profile(ParseCursor& cursor, const Token& word, const StageWords& words) {
    const auto named = [&](std::string_view profile) { return same_word(profile, word.text); };
    if (std::any_of(words.profiles.begin(), words.profiles.end(), named)) return;
    // Another stage's profile has similar letters, but is never the intended one.
    const bool other_stage =
        std::any_of(std::begin(d3d9::stages), std::end(d3d9::stages), [&](const StageWords& other) {
            return other.stage != words.stage && same_word(word.text.substr(0, other.prefix.size()), other.prefix);
        });
    cursor.fail("PG024", word.at,
                quoted(word) + " is not a profile for a " + std::string(words.state) +
                    (other_stage ? "; write " + std::string(words.usual)
                                 : suggestion(word.text, words.profiles, "; did you mean '", "'?")));
}

Compile parse_compile(ParseCursor& cursor, const StageWords& words) {
    Compile compile;
    compile.at = cursor.take().at;
    const Token& profile =
        cursor.expect_identifier("a profile such as " + std::string(words.usual) + " behind 'compile'");
    check_profile(cursor, profile, words);
    compile.profile = profile.text;
    const Token& entry = cursor.expect_identifier("the entry point's name behind the profile");
    compile.entry = entry.text;
    compile.entry_at = entry.at;
    cursor.expect("(", "after '" + std::string(entry.text) + "'; the arguments may be none");
    if (!cursor.is(")")) {
        do compile.arguments.push_back(cursor.skip_to(",)", "an argument of '" + std::string(entry.text) + "'"));
        while (cursor.take_if(","));
    }
    cursor.expect(")", "after the arguments of '" + std::string(entry.text) + "'");
    return compile;
}

// The value as written. A single word is upper-cased, <name> and (name) lose their brackets.
std::string state_value_text(const ParseCursor& cursor, TokenRange range) {
    const Tokens& tokens = cursor.effect.tokens;
    if (range.size() == 3 && (tokens[range.begin].is("<") || tokens[range.begin].is("(")))
        return std::string(tokens[range.begin + 1].text);
    std::string text = text_of(cursor.effect, range);
    const bool words = std::all_of(tokens.begin() + static_cast<std::ptrdiff_t>(range.begin),
                                   tokens.begin() + static_cast<std::ptrdiff_t>(range.end),
                                   [](const Token& token) { return token.is_identifier() || token.is("|"); });
    return words ? upper(text) : text;
}

TokenRange parse_state_value(ParseCursor& cursor, const std::string& name) {
    const TokenRange value = cursor.skip_to(";}", "the value of '" + name + "'");
    if (value.empty()) cursor.fail("PG020", cursor.peek().at, "expected a value for '" + name + "'");
    for (std::size_t i = value.begin; i < value.end; ++i)
        if (cursor.effect.tokens[i].is("="))
            cursor.fail("PG020", cursor.effect.tokens[i].at, "a ';' is missing after the value of '" + name + "'");
    cursor.expect(";", "after the value of '" + name + "'");
    return value;
}

StateAssignment begin_state(ParseCursor& cursor, const std::string& where) {
    StateAssignment state;
    state.at = cursor.peek().at;
    state.range.begin = cursor.at;
    state.name = cursor.expect_identifier("a state's name or '}' in " + where).text;
    if (cursor.is("[")) {
        state.index = cursor.skip_brackets();
        if (state.index.empty()) cursor.fail("PG020", state.at, "expected an index in '" + state.name + "[]'");
        state.name += '[' + text_of(cursor.effect, state.index) + ']';
    }
    cursor.expect("=", "after '" + state.name + "'");
    return state;
}

void finish_state(ParseCursor& cursor, StateAssignment& state) {
    state.words = parse_state_value(cursor, state.name);
    state.value = state_value_text(cursor, state.words);
    state.range.end = cursor.at;
}

std::optional<Compile>& shader_of(ParsedPass& pass, Stage stage) {
    return stage == Stage::Vertex ? pass.vertex : stage == Stage::Pixel ? pass.pixel : pass.compute;
}

void parse_shader_state(ParseCursor& cursor, ParsedPass& pass, const StageWords& words, Location at) {
    const std::string name(words.state);
    std::optional<Compile>& shader = shader_of(pass, words.stage);
    if (shader) cursor.fail("PG025", at, "pass '" + pass.name + "' sets " + name + " twice");
    const Token& word = cursor.peek();
    if (same_word(word.text, "compile")) {
        shader = parse_compile(cursor, words);
        cursor.expect(";", "after the " + name + " of pass '" + pass.name + "'");
        return;
    }
    if (same_word(word.text, "null")) {
        cursor.take();
        cursor.expect(";", "after NULL");
        return;
    }
    if (same_word(word.text, "asm") || same_word(word.text, "asm_fragment") || same_word(word.text, "compile_fragment"))
        cursor.fail("PG026", word.at, quoted(word) + " is not supported; write the shader in HLSL and `compile` it");
    static constexpr std::string_view compile[] = {"compile"};
    cursor.fail("PG026", word.at,
                name + " needs 'compile PROFILE ENTRY(ARGUMENTS)', not " + quoted(word) +
                    suggestion(word.text, compile, "; did you mean '", "'?"));
}

/// A pass computes or draws.
void check_stages(ParseCursor& cursor, const ParsedPass& pass, const std::string& technique) {
    const std::string where = "pass '" + pass.name + "' of technique '" + technique + "'";
    if (pass.compute && (pass.vertex || pass.pixel)) {
        report_error(cursor.diagnostics, "PG028", cursor.sources.place(pass.compute->at),
                     where + " has a ComputeShader and a " + (pass.vertex ? "VertexShader" : "PixelShader") +
                         "; a pass either computes or draws; move the ComputeShader into a pass of its own");
    } else if (!pass.compute && !pass.vertex && !pass.pixel) {
        report_error(cursor.diagnostics, "PG027", cursor.sources.place(pass.at),
                     where +
                         " has no shader, and there is no fixed-function pipeline; add VertexShader = compile ...; "
                         "and PixelShader = compile ...;");
    } else if (!pass.compute && !pass.vertex) {
        report_warning(cursor.diagnostics, "PG027", cursor.sources.place(pass.at),
                       where + " has no vertex shader; the application must provide one to draw with it");
    }
}

ParsedPass parse_pass(ParseCursor& cursor, const ParsedTechnique& technique) {
    ParsedPass pass;
    pass.at = cursor.take().at;
    pass.name = "p" + std::to_string(technique.passes.size());
    if (cursor.peek().is_identifier()) {
        pass.at = cursor.peek().at;
        pass.name = cursor.take().text;
    }
    skip_annotations(cursor);
    const std::string where = "pass '" + pass.name + "'";
    cursor.expect("{", "to begin " + where);
    while (!cursor.is("}")) {
        if (cursor.done()) cursor.fail("PG021", pass.at, where + " has no closing '}'");
        if (cursor.take_if(";")) continue;
        StateAssignment state = begin_state(cursor, where);
        const auto shader = std::find_if(std::begin(d3d9::stages), std::end(d3d9::stages),
                                         [&](const StageWords& words) { return same_word(state.name, words.state); });
        if (shader != std::end(d3d9::stages)) {
            parse_shader_state(cursor, pass, *shader, state.at);
            continue;
        }
        if (same_word(cursor.peek().text, "compile")) {
            static constexpr std::string_view words[] = {"VertexShader", "PixelShader", "ComputeShader"};
            cursor.fail(
                "PG026", state.at,
                "'" + state.name + "' takes no shader" + suggestion(state.name, words, "; did you mean '", "'?"));
        }
        finish_state(cursor, state);
        pass.states.push_back(std::move(state));
    }
    cursor.take();
    check_stages(cursor, pass, technique.name);
    return pass;
}

}  // namespace

bool same_word(std::string_view a, std::string_view b) {
    return d3d9::same_word(a, b);
}

void parse_technique(ParseCursor& cursor) {
    ParsedTechnique technique;
    const std::size_t begin = cursor.at;
    technique.at = cursor.take().at;
    technique.name = "technique" + std::to_string(cursor.effect.techniques.size());
    if (cursor.peek().is_identifier()) {
        technique.at = cursor.peek().at;
        technique.name = cursor.take().text;
    }
    skip_annotations(cursor);
    cursor.expect("{", "to begin technique '" + technique.name + "'");
    while (!cursor.is("}")) {
        if (cursor.done()) cursor.fail("PG021", technique.at, "technique '" + technique.name + "' has no closing '}'");
        if (cursor.take_if(";")) continue;
        static constexpr std::string_view words[] = {"pass"};
        if (!same_word(cursor.peek().text, "pass"))
            cursor.fail("PG020", cursor.peek().at,
                        "expected 'pass' or '}' in technique '" + technique.name + "', not " + quoted(cursor.peek()) +
                            suggestion(cursor.peek().text, words, "; did you mean '", "'?"));
        ParsedPass pass = parse_pass(cursor, technique);
        for (const ParsedPass& other : technique.passes)
            if (other.name == pass.name)
                report_error(cursor.diagnostics, "PG023", cursor.sources.place(pass.at),
                             "technique '" + technique.name + "' has two passes named '" + pass.name + "'");
        technique.passes.push_back(std::move(pass));
    }
    cursor.take();
    cursor.take_if(";");
    cursor.drop({begin, cursor.at});
    if (technique.passes.empty())
        report_error(cursor.diagnostics, "PG027", cursor.sources.place(technique.at),
                     "technique '" + technique.name + "' has no pass; add one with its shaders");
    for (const ParsedTechnique& other : cursor.effect.techniques)
        if (other.name == technique.name)
            report_error(cursor.diagnostics, "PG023", cursor.sources.place(technique.at),
                         "technique '" + technique.name + "' is declared twice; the first stands in line " +
                             std::to_string(other.at.line));
    cursor.effect.techniques.push_back(std::move(technique));
}

bool is_sampler_type(const Token& token) {
    static constexpr std::array<std::string_view, 5> types = {"sampler", "sampler1D", "sampler2D", "sampler3D",
                                                              "samplerCUBE"};
    return std::any_of(types.begin(), types.end(), [&](std::string_view type) { return same_word(type, token.text); });
}

bool is_texture_type(const Token& token) {
    static constexpr std::array<std::string_view, 5> types = {"texture", "texture1D", "texture2D", "texture3D",
                                                              "textureCUBE"};
    // `Texture2D` with a capital T is D3D10's object, which differs.
    return token.is("Texture") ||
           (!token.text.starts_with('T') && std::any_of(types.begin(), types.end(), [&](std::string_view type) {
               return same_word(type, token.text);
           }));
}

void parse_samplers(ParseCursor& cursor) {
    const std::size_t begin = cursor.at;
    cursor.take();
    std::size_t item_begin = begin;
    do {
        Sampler sampler;
        sampler.type_token = begin;
        const Token& name = cursor.expect_identifier("the sampler's name");
        sampler.name = name.text;
        sampler.at = name.at;
        if (cursor.is("["))
            cursor.fail(
                "PG022", cursor.peek().at,
                "arrays of samplers are not supported; declare '" + std::string(name.text) + "' as single samplers");
        Variable declarator;
        declarator.name = name.text;
        // Only the part before '=' is an ordinary declarator; a sampler's states are not an expression.
        while (cursor.is(":")) {
            cursor.take();
            cursor.expect_identifier("'register' or a semantic");
            if (cursor.is("(")) cursor.skip_brackets();
        }
        skip_annotations(cursor);
        if (cursor.take_if("=")) {
            if (!same_word(cursor.peek().text, "sampler_state") && !cursor.is("{")) {
                static constexpr std::string_view words[] = {"sampler_state"};
                cursor.fail("PG020", cursor.peek().at,
                            "expected 'sampler_state' behind '=', not " + quoted(cursor.peek()) +
                                suggestion(cursor.peek().text, words, "; did you mean '", "'?"));
            }
            if (!cursor.is("{")) cursor.take();
            if (!cursor.is("{")) cursor.expect("{", "after 'sampler_state'");
        }
        if (cursor.take_if("{")) {
            const std::string where = "sampler '" + std::string(sampler.name) + "'";
            while (!cursor.is("}")) {
                if (cursor.done()) cursor.fail("PG021", sampler.at, where + " has no closing '}'");
                if (cursor.take_if(";")) continue;
                StateAssignment state = begin_state(cursor, where);
                finish_state(cursor, state);
                sampler.states.push_back(std::move(state));
            }
            cursor.take();
        }
        sampler.range = {item_begin, cursor.at};
        item_begin = cursor.at;
        cursor.effect.items.push_back({ItemKind::Sampler, cursor.effect.samplers.size(), 1, sampler.range});
        cursor.effect.samplers.push_back(std::move(sampler));
    } while (cursor.take_if(","));
    cursor.expect(";", "after sampler '" + std::string(cursor.effect.samplers.back().name) + "'");
    cursor.drop({begin, cursor.at});
}

void parse_textures(ParseCursor& cursor) {
    const std::size_t begin = cursor.at;
    cursor.take();
    do {
        Variable declarator;
        const Token& name = cursor.expect_identifier("the texture's name");
        declarator.name = name.text;
        parse_declarator(cursor, declarator, ",;");
        cursor.effect.textures.push_back({name.text, name.at});
    } while (cursor.take_if(","));
    cursor.expect(";", "after texture '" + std::string(cursor.effect.textures.back().name) + "'");
    cursor.drop({begin, cursor.at});
}

}  // namespace permgen

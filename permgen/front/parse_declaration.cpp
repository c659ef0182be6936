#include "front/parse_declaration.h"

#include <array>

#include "common/nearest.h"
#include "d3d9/storage_types.h"
#include "front/parse.h"
#include "front/parse_numthreads.h"
#include "front/report.h"

namespace permgen {
namespace {

// The words that can start a declaration at file scope, for "did you mean".
constexpr std::array<std::string_view, 22> file_scope_words = {"technique",         "struct",
                                                               "cbuffer",           "typedef",
                                                               "sampler",           "sampler2D",
                                                               "sampler3D",         "static",
                                                               "texture",           "texture2D",
                                                               "texture3D",         "samplerCUBE",
                                                               "uniform",           "const",
                                                               "groupshared",       "RWTexture1D",
                                                               "RWTexture2D",       "RWTexture3D",
                                                               "StructuredBuffer",  "RWStructuredBuffer",
                                                               "ByteAddressBuffer", "RWByteAddressBuffer"};

bool is_uppercase_void(const TypeName& type) {
    return type.name == "void";
}

void check_not_groupshared(ParseCursor& cursor, const Qualifiers& qualifiers, Location at) {
    if (qualifiers.groupshared)
        cursor.fail("PG022", at, "'groupshared' is for variables at file scope; declare this one there");
}

void parse_members(ParseCursor& cursor, const std::string& owner, std::vector<Variable>& members) {
    cursor.expect("{", "in the declaration of '" + owner + "'");
    while (!cursor.is("}")) {
        if (cursor.done())
            cursor.fail("PG021", cursor.peek().at, "the declaration of '" + owner + "' has no closing '}'");
        if (cursor.take_if(";")) continue;
        Variable first;
        first.range.begin = cursor.at;
        const Location at = cursor.peek().at;
        first.qualifiers = parse_qualifiers(cursor);
        check_not_groupshared(cursor, first.qualifiers, at);
        if (cursor.is("struct"))
            cursor.fail("PG022", cursor.peek().at,
                        "declare the inner struct of '" + owner + "' at file scope, by name");
        first.type = parse_type(cursor);
        if (is_uppercase_void(first.type))
            cursor.fail("PG022", first.type.at, "a member of '" + owner + "' cannot be void");
        do {
            Variable member = first;
            const Token& name = cursor.expect_identifier("a member's name in '" + owner + "'");
            member.name = name.text;
            member.at = name.at;
            if (cursor.is("("))
                cursor.fail(
                    "PG022", name.at,
                    "'" + owner + "' cannot have functions; move '" + std::string(name.text) + "' to file scope");
            for (const Variable& other : members)
                if (other.name == member.name)
                    cursor.fail("PG023", name.at,
                                "'" + owner + "' has two members named '" + std::string(name.text) + "'");
            parse_declarator(cursor, member, ",;}");
            member.range.end = cursor.at;
            members.push_back(member);
        } while (cursor.take_if(","));
        cursor.expect(";", "after member '" + std::string(members.back().name) + "' of '" + owner + "'");
    }
    cursor.take();
}

Variable parse_parameter(ParseCursor& cursor, std::string_view function) {
    Variable parameter;
    parameter.range.begin = cursor.at;
    const Location at = cursor.peek().at;
    parameter.qualifiers = parse_qualifiers(cursor);
    check_not_groupshared(cursor, parameter.qualifiers, at);
    parameter.type = parse_type(cursor);
    if (!cursor.peek().is_identifier())
        cursor.fail("PG022", cursor.peek().at,
                    "a parameter of '" + std::string(function) + "' has no name; give every parameter one");
    const Token& name = cursor.take();
    parameter.name = name.text;
    parameter.at = name.at;
    parse_declarator(cursor, parameter, ",)");
    parameter.range.end = cursor.at;
    return parameter;
}

void parse_function(ParseCursor& cursor, Function function) {
    cursor.expect("(", "after '" + std::string(function.name) + "'");
    if (cursor.is("void") && cursor.peek(1).is(")")) cursor.take();
    while (!cursor.is(")")) {
        function.parameters.push_back(parse_parameter(cursor, function.name));
        if (!cursor.is(")")) cursor.expect(",", "between the parameters of '" + std::string(function.name) + "'");
    }
    cursor.take();
    if (cursor.is(":")) {
        const std::size_t begin = cursor.at;
        cursor.take();
        function.semantic = parse_semantic(cursor.expect_identifier("the result's semantic"));
        cursor.drop({begin, cursor.at});
    }
    if (cursor.is("{")) {
        function.body.begin = cursor.at;
        cursor.skip_brackets();
        function.body.end = cursor.at;
    } else {
        cursor.expect(";", "or a body in braces after function '" + std::string(function.name) + "'");
    }
    function.range.end = cursor.at;
    cursor.effect.items.push_back({ItemKind::Function, cursor.effect.functions.size(), 1, function.range});
    cursor.effect.functions.push_back(std::move(function));
}

}  // namespace

Qualifiers parse_qualifiers(ParseCursor& cursor) {
    Qualifiers qualifiers;
    while (true) {
        const Token& word = cursor.peek();
        const std::size_t index = cursor.at;
        bool dropped = false;
        if (word.is("static"))
            qualifiers.is_static = true;
        else if (word.is("const"))
            qualifiers.is_const = true;
        else if (word.is("uniform"))
            qualifiers.is_uniform = dropped = true;
        else if (word.is("extern") || word.is("shared") || word.is("volatile"))
            dropped = true;
        else if (word.is("in"))
            qualifiers.in = true;
        else if (word.is("out"))
            qualifiers.out = true;
        else if (word.is("inout"))
            qualifiers.in = qualifiers.out = true;
        else if (word.is("row_major"))
            qualifiers.row_major = true;
        else if (word.is("column_major") || word.is("inline")) {
        } else if (word.is("centroid"))
            qualifiers.centroid = dropped = true;
        else if (word.is("noperspective"))
            qualifiers.noperspective = dropped = true;
        else if (word.is("nointerpolation"))
            qualifiers.nointerpolation = dropped = true;
        else if (word.is("groupshared"))
            qualifiers.groupshared = true;
        else if (word.is("linear") || word.is("precise"))
            dropped = true;
        else
            return qualifiers;
        cursor.take();
        if (dropped) cursor.drop({index, index + 1});
    }
}

TypeName parse_type(ParseCursor& cursor) {
    TypeName type;
    if (cursor.is("unsigned") && (cursor.peek(1).is("int") || cursor.peek(1).is("short"))) {
        cursor.drop({cursor.at, cursor.at + 1});
        cursor.take();
        cursor.effect.tokens[cursor.at].text = "uint";
    }
    if (d3d9::find_storage_type(cursor.peek().text))
        cursor.fail("PG041", cursor.peek().at,
                    quoted(cursor.peek()) + " may only be declared at file scope; use the resource by its name");
    type.range.begin = cursor.at;
    const Token& word = cursor.expect_identifier("a type");
    type.name = word.text;
    type.at = word.at;
    if ((word.is("vector") || word.is("matrix")) && cursor.take_if("<")) {
        while (!cursor.is(">")) {
            const Token& argument = cursor.peek();
            if (argument.kind != TokenKind::Identifier && argument.kind != TokenKind::Number)
                cursor.fail("PG020", argument.at,
                            "expected a component type or a size in '" + std::string(type.name) + "<...>', not " +
                                quoted(argument));
            type.arguments.emplace_back(cursor.take().text);
            if (!cursor.is(">")) cursor.expect(",", "in '" + std::string(type.name) + "<...>'");
        }
        cursor.take();
    }
    type.range.end = cursor.at;
    return type;
}

void skip_annotations(ParseCursor& cursor) {
    if (!cursor.is("<")) return;
    const std::size_t begin = cursor.at;
    cursor.take();
    while (!cursor.is(">")) {
        if (cursor.done())
            cursor.fail("PG021", cursor.effect.tokens[begin].at, "these annotations have no closing '>'");
        if (cursor.is(">=")) {
            // "... >= value": the annotations end right before the initializer.
            cursor.effect.tokens[cursor.at].text = "=";
            cursor.drop({begin, cursor.at});
            return;
        }
        if (cursor.is("{") || cursor.is("(") || cursor.is("["))
            cursor.skip_brackets();
        else
            cursor.take();
    }
    cursor.take();
    cursor.drop({begin, cursor.at});
}

void parse_declarator(ParseCursor& cursor, Variable& variable, std::string_view ends) {
    while (cursor.is("[")) variable.dimensions.push_back(cursor.skip_brackets());
    while (cursor.is(":")) {
        const std::size_t begin = cursor.at;
        cursor.take();
        const Token& word = cursor.expect_identifier("a semantic or register");
        if (word.is("register") || word.is("packoffset")) {
            if (!cursor.is("(")) cursor.expect("(", "after '" + std::string(word.text) + "'");
            cursor.skip_brackets();
            if (word.is("packoffset")) continue;
        } else {
            variable.semantic = parse_semantic(word);
        }
        cursor.drop({begin, cursor.at});
    }
    skip_annotations(cursor);
    if (cursor.take_if("=")) {
        variable.initializer = cursor.skip_to(ends, "the initializer of '" + std::string(variable.name) + "'");
        if (variable.initializer.empty()) cursor.fail("PG020", cursor.peek().at, "expected a value behind '='");
    }
}

void parse_struct(ParseCursor& cursor) {
    Struct structure;
    structure.range.begin = cursor.at;
    cursor.take();
    const Token& name = cursor.expect_identifier("the struct's name");
    structure.name = name.text;
    structure.at = name.at;
    parse_members(cursor, std::string(name.text), structure.members);
    if (cursor.peek().is_identifier())
        cursor.fail("PG020", cursor.peek().at,
                    "expected ';' after struct '" + std::string(structure.name) + "'; declare the variable separately");
    cursor.expect(";", "after struct '" + std::string(structure.name) + "'");
    structure.range.end = cursor.at;
    cursor.effect.items.push_back({ItemKind::Struct, cursor.effect.structs.size(), 1, structure.range});
    cursor.effect.structs.push_back(std::move(structure));
}

void parse_typedef(ParseCursor& cursor) {
    Typedef alias;
    alias.range.begin = cursor.at;
    cursor.take();
    parse_qualifiers(cursor);
    alias.type = parse_type(cursor);
    alias.name = cursor.expect_identifier("the new type's name").text;
    while (cursor.is("[")) cursor.skip_brackets();
    cursor.expect(";", "after typedef '" + std::string(alias.name) + "'");
    alias.range.end = cursor.at;
    cursor.effect.items.push_back({ItemKind::Typedef, cursor.effect.typedefs.size(), 1, alias.range});
    cursor.effect.typedefs.push_back(alias);
}

void parse_constant_buffer(ParseCursor& cursor) {
    ConstantBuffer buffer;
    buffer.range.begin = cursor.at;
    cursor.take();
    const Token& name = cursor.expect_identifier("the cbuffer's name");
    buffer.name = name.text;
    buffer.at = name.at;
    if (cursor.is(":")) {
        const std::size_t begin = cursor.at;
        cursor.take();
        cursor.expect("register", "after ':'");
        if (!cursor.is("(")) cursor.expect("(", "after 'register'");
        cursor.skip_brackets();
        cursor.drop({begin, cursor.at});
    }
    skip_annotations(cursor);
    buffer.open_brace = cursor.at;
    parse_members(cursor, std::string(name.text), buffer.members);
    cursor.take_if(";");
    buffer.range.end = cursor.at;
    cursor.effect.items.push_back({ItemKind::ConstantBuffer, cursor.effect.constant_buffers.size(), 1, buffer.range});
    cursor.effect.constant_buffers.push_back(std::move(buffer));
}

void parse_function_or_globals(ParseCursor& cursor) {
    const std::size_t begin = cursor.at;
    std::optional<ThreadGroup> threads;
    while (cursor.is("[")) {
        if (cursor.peek(1).is("["))
            cursor.fail("PG022", cursor.peek().at,
                        "remove the [[...]] attribute; permgen gives out locations, bindings and constant ids itself");
        if (!begins_numthreads(cursor)) {
            cursor.skip_brackets();
            continue;
        }
        if (threads) cursor.fail("PG029", cursor.peek(1).at, "[numthreads] is given twice; remove one");
        threads = parse_numthreads(cursor);
    }
    const Location qualifiers_at = cursor.peek().at;
    const Qualifiers qualifiers = parse_qualifiers(cursor);
    if (!cursor.peek().is_identifier())
        cursor.fail("PG020", cursor.peek().at, "expected a declaration, not " + quoted(cursor.peek()));
    const TypeName type = parse_type(cursor);
    const std::string hint = suggestion(type.name, file_scope_words, "; did you mean '", "'?");
    if (!cursor.peek().is_identifier())
        cursor.fail(
            "PG020", type.at,
            "expected a declaration, not '" + std::string(type.name) + "' followed by " + quoted(cursor.peek()) + hint);
    const Token name = cursor.take();
    if (cursor.is("(")) {
        Function function;
        function.name = name.text;
        function.result = type;
        function.at = name.at;
        function.threads = std::move(threads);
        check_not_groupshared(cursor, qualifiers, qualifiers_at);
        function.range.begin = begin;
        return parse_function(cursor, std::move(function));
    }
    if (cursor.is("{"))
        cursor.fail("PG020", type.at,
                    "'" + std::string(type.name) + " " + std::string(name.text) +
                        "' is not a declaration that may have a '{'" + hint);
    if (threads)
        cursor.fail("PG029", threads->at, "[numthreads] belongs in front of a function; move it there or remove it");
    if (qualifiers.groupshared && (qualifiers.is_static || qualifiers.is_const))
        cursor.fail("PG022", qualifiers_at, "a groupshared variable is neither static nor const; write one word only");
    const std::size_t first = cursor.effect.globals.size();
    Variable variable;
    variable.type = type;
    variable.qualifiers = qualifiers;
    variable.name = name.text;
    variable.at = name.at;
    std::vector<Variable> declared;
    while (true) {
        if (variable.type.name == "void")
            cursor.fail("PG022", variable.at, "'" + std::string(variable.name) + "' cannot be void");
        variable.range.begin = begin;
        parse_declarator(cursor, variable, ",;");
        if (qualifiers.groupshared && !variable.initializer.empty())
            cursor.fail("PG022", variable.at,
                        "groupshared '" + std::string(variable.name) +
                            "' cannot have an initial value; let one thread set it, then wait with "
                            "GroupMemoryBarrierWithGroupSync()");
        declared.push_back(variable);
        if (!cursor.take_if(",")) break;
        const Token& next = cursor.expect_identifier("a name behind ','");
        Variable another;
        another.type = type;
        another.qualifiers = qualifiers;
        another.name = next.text;
        another.at = next.at;
        variable = another;
    }
    cursor.expect(";", "after '" + std::string(declared.back().name) + "'");
    for (Variable& each : declared) {
        each.range.end = cursor.at;
        cursor.effect.globals.push_back(each);
    }
    cursor.effect.items.push_back({ItemKind::Globals, first, declared.size(), {begin, cursor.at}});
}

}  // namespace permgen

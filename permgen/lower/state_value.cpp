#include "lower/state_value.h"

#include <algorithm>
#include <limits>

#include "common/nearest.h"
#include "front/parse_cursor.h"
#include "front/preprocess_macro.h"
#include "lower/lower_arguments.h"

namespace permgen {
namespace {

using d3d9::StateRow;

/// (1) and <1> mean 1; -1 keeps its sign.
std::span<const Token> without_brackets(std::span<const Token> tokens) {
    while (tokens.size() > 2 &&
           ((tokens.front().is("(") && tokens.back().is(")")) || (tokens.front().is("<") && tokens.back().is(">"))))
        tokens = tokens.subspan(1, tokens.size() - 2);
    return tokens;
}

std::string what_it_takes(const StateRow& row) {
    switch (row.kind) {
        case ValueKind::Bool:
            return "TRUE or FALSE";
        case ValueKind::Integer:
            return "a whole number from 0 to 4294967295";
        case ValueKind::Float:
            return "a number";
        case ValueKind::Colour:
            return "a colour such as 0xff80ff00 (alpha, red, green, blue)";
        default:
            break;
    }
    constexpr std::size_t max_names = 12;  // longer lists hide the sentence
    std::string names;
    for (std::size_t i = 0; i < std::min(row.values.size(), max_names); ++i)
        names += (i ? ", " : "") + std::string(row.values[i].name);
    if (row.values.size() > max_names) names += ", ...";
    return (row.kind == ValueKind::Flags ? "a number, or names joined by '|', of " : "one of ") + names;
}

StateValue fail(const StateRow& row, const Token& at, std::string found) {
    StateValue value;
    value.at = &at;
    value.problem = "'" + std::string(row.name) + "' takes " + what_it_takes(row) + ", not " + std::move(found);
    return value;
}

StateValue unknown_word(const StateRow& row, const Token& word) {
    std::vector<std::string_view> names;
    for (const d3d9::NamedValue& value : row.values) names.push_back(value.name);
    StateValue value = fail(row, word, quoted(word));
    value.problem += suggestion(word.text, names, "; did you mean '", "'?");
    return value;
}

bool fits(const StateRow& row, std::uint32_t bits) {
    switch (row.kind) {
        case ValueKind::Bool:
            return bits <= 1;
        case ValueKind::Enum:
            return d3d9::find_value(row, bits) != nullptr;
        case ValueKind::Flags:
            // If the renderer implements the flags, it supports only the named ones.
            return row.support != d3d9::Support::Mapped || (bits & ~d3d9::all_bits(row)) == 0;
        default:
            return true;
    }
}

StateValue read_number(const StateRow& row, std::span<const Token> tokens) {
    std::string problem;
    const Token& number = tokens.back();
    const std::string written = "'" + spelled(tokens) + "'";
    if (row.kind == ValueKind::Float) {
        if (const auto bits = literal_bits(tokens, ScalarType::Float, problem)) return {row.kind, *bits, {}, nullptr};
        return fail(row, number, written);
    }
    const bool negative = tokens.front().is("-");
    const auto bits = literal_bits(tokens, negative ? ScalarType::Int : ScalarType::Uint, problem);
    if (!bits || !fits(row, *bits)) return fail(row, number, written);
    return {row.kind, *bits, {}, nullptr};
}

bool is_number(std::span<const Token> tokens) {
    const bool has_sign = tokens.size() == 2 && (tokens[0].is("-") || tokens[0].is("+"));
    return (tokens.size() == 1 || has_sign) && tokens.back().kind == TokenKind::Number;
}

/// Words and numbers with a '|' between each two.
bool is_joined(std::span<const Token> tokens) {
    if (tokens.size() % 2 == 0) return tokens.back().is("|");
    for (std::size_t i = 0; i < tokens.size(); ++i)
        if (i % 2 ? !tokens[i].is("|") : !tokens[i].is_identifier() && tokens[i].kind != TokenKind::Number)
            return false;
    return true;
}

StateValue read_flags(const StateRow& row, std::span<const Token> tokens) {
    StateValue value{row.kind, 0, {}, nullptr};
    if (tokens.back().is("|")) return fail(row, tokens.back(), "a '|' at the end");
    for (std::size_t i = 0; i < tokens.size(); i += 2) {
        const d3d9::NamedValue* word = d3d9::find_value(row, tokens[i].text);
        std::string problem;
        const auto number = literal_bits(tokens.subspan(i, 1), ScalarType::Uint, problem);
        if (!word && tokens[i].is_identifier()) return unknown_word(row, tokens[i]);
        if (!word && (!number || !fits(row, *number))) return fail(row, tokens[i], quoted(tokens[i]));
        value.bits |= word ? word->bits : *number;
    }
    return value;
}

}  // namespace

StateValue read_state_value(const StateRow& row, std::span<const Token> tokens) {
    if (row.kind == ValueKind::Object) return {ValueKind::Object, 0, {}, nullptr};
    const StateValue expression{ValueKind::Expression, 0, {}, nullptr};
    tokens = without_brackets(tokens);
    if (tokens.size() == 1)
        if (const d3d9::NamedValue* word = d3d9::find_value(row, tokens.front().text))
            return {row.kind, word->bits, {}, nullptr};
    if (row.kind == ValueKind::Flags && is_joined(tokens)) return read_flags(row, tokens);
    if (is_number(tokens)) return read_number(row, tokens);
    if (tokens.size() == 1 && tokens.front().is_identifier()) return unknown_word(row, tokens.front());
    if (tokens.size() == 1) return fail(row, tokens.front(), quoted(tokens.front()));
    return expression;
}

}  // namespace permgen

#include "front/lex.h"

#include <array>

#include "front/report.h"

namespace permgen {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_word_start(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_word(char c) {
    return is_word_start(c) || is_digit(c);
}
bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

// Longest first, so that the first match is the right one.
constexpr std::array<std::string_view, 24> long_punctuators = {
    "<<=", ">>=", "...", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "++",
    "--",  "+=",  "-=",  "*=", "/=", "%=", "&=", "|=", "^=", "->", "::", "##"};
constexpr std::string_view single_punctuators = "+-*/%&|^~!<>=?:;,.(){}[]#";

struct Cursor {
    const SourceFile& source;
    std::int32_t name;
    std::size_t at = 0;
    std::size_t run = 0;

    char peek(std::size_t ahead = 0) const { return at + ahead < source.text.size() ? source.text[at + ahead] : '\0'; }
    bool done() const { return at >= source.text.size(); }

    Location location() {
        while (run + 1 < source.runs.size() && source.runs[run + 1].offset <= at) ++run;
        const SourceRun& here = source.runs[run];
        return {name, here.line, here.column + static_cast<std::int32_t>(at - here.offset)};
    }
};

// A preprocessing number: everything up to the next character that cannot belong to one, so that "1.0f",
// "0x1F" and swizzled literals like "1.xxx" stay whole.
std::size_t number_length(std::string_view text) {
    const bool hexadecimal = text.size() > 1 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
    std::size_t length = 1;
    while (length < text.size()) {
        const char c = text[length];
        const char before = text[length - 1];
        const bool exponent_sign = (c == '+' || c == '-') && !hexadecimal && (before == 'e' || before == 'E');
        if (!is_word(c) && c != '.' && !exponent_sign) break;
        ++length;
    }
    return length;
}

std::size_t punctuator_length(std::string_view text) {
    for (std::string_view candidate : long_punctuators)
        if (text.starts_with(candidate)) return candidate.size();
    return single_punctuators.find(text.front()) != std::string_view::npos ? 1 : 0;
}

// Up to the closing quote, backslash escapes included; 0 when the line ends first.
std::size_t string_length(std::string_view text) {
    for (std::size_t i = 1; i < text.size() && text[i] != '\n'; ++i) {
        if (text[i] == '"') return i + 1;
        if (text[i] == '\\' && i + 1 < text.size() && text[i + 1] != '\n') ++i;
    }
    return 0;
}

}  // namespace

Tokens lex(const SourceFile& source, std::int32_t name, const Sources& sources, Diagnostics& diagnostics) {
    Tokens tokens;
    Cursor cursor{source, name};
    const std::string_view text = source.text;
    bool starts_line = true;
    bool follows_space = false;
    while (!cursor.done()) {
        const char c = cursor.peek();
        if (c == '\n') {
            starts_line = true;
            ++cursor.at;
            continue;
        }
        if (is_blank(c)) {
            follows_space = true;
            ++cursor.at;
            continue;
        }
        if (c == '/' && cursor.peek(1) == '/') {
            const std::size_t end = text.find('\n', cursor.at);
            cursor.at = end == std::string_view::npos ? text.size() : end;
            continue;
        }
        if (c == '/' && cursor.peek(1) == '*') {
            const std::size_t end = text.find("*/", cursor.at + 2);
            if (end == std::string_view::npos) {
                report_error(diagnostics, "PG003", sources.place(cursor.location()),
                             "this comment has no end; add \"*/\"");
                break;
            }
            cursor.at = end + 2;
            follows_space = true;
            continue;
        }

        Token token;
        token.at = cursor.location();
        token.starts_line = starts_line;
        token.follows_space = follows_space || starts_line;
        std::size_t length = 0;
        const std::string_view rest = text.substr(cursor.at);
        if (is_word_start(c)) {
            token.kind = TokenKind::Identifier;
            length = 1;
            while (length < rest.size() && is_word(rest[length])) ++length;
        } else if (is_digit(c) || (c == '.' && is_digit(cursor.peek(1)))) {
            token.kind = TokenKind::Number;
            length = number_length(rest);
        } else if (c == '"' && (length = string_length(rest)) != 0) {
            token.kind = TokenKind::String;
        } else if ((length = punctuator_length(rest)) != 0) {
            token.kind = TokenKind::Punctuator;
        } else {
            token.kind = TokenKind::Unknown;
            length = 1;
        }
        token.text = rest.substr(0, length);
        tokens.push_back(token);
        cursor.at += length;
        starts_line = false;
        follows_space = false;
    }
    return tokens;
}

std::string_view unquoted(const Token& token) {
    return token.text.size() >= 2 ? token.text.substr(1, token.text.size() - 2) : std::string_view();
}

}  // namespace permgen

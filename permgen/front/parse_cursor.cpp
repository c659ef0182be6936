#include "front/parse_cursor.h"

#include "front/parse.h"
#include "front/preprocess_macro.h"
#include "front/report.h"

namespace permgen {
namespace {

bool opens(const Token& token) {
    return token.is("(") || token.is("[") || token.is("{");
}
bool closes(const Token& token) {
    return token.is(")") || token.is("]") || token.is("}");
}

std::string_view partner(const Token& token) {
    return token.is("(") ? ")" : token.is("[") ? "]" : "}";
}

}  // namespace

bool ParseCursor::take_if(std::string_view spelling) {
    if (!is(spelling)) return false;
    take();
    return true;
}

void ParseCursor::fail(const char* code, Location place, std::string message) {
    report_error(diagnostics, code, sources.place(place), std::move(message));
    throw SyntaxError();
}

void ParseCursor::expect(std::string_view spelling, const std::string& where) {
    if (!is(spelling))
        fail("PG020", peek().at, "expected '" + std::string(spelling) + "' " + where + ", not " + quoted(peek()));
    take();
}

const Token& ParseCursor::expect_identifier(const std::string& what) {
    if (!peek().is_identifier()) fail("PG020", peek().at, "expected " + what + ", not " + quoted(peek()));
    return take();
}

TokenRange ParseCursor::skip_brackets() {
    std::vector<std::size_t> open;
    const std::size_t begin = at;
    do {
        const Token& token = peek();
        if (token.kind == TokenKind::End) {
            const Token& unclosed = effect.tokens[open.back()];
            fail("PG021", unclosed.at, quoted(unclosed) + " has no closing '" + std::string(partner(unclosed)) + "'");
        }
        if (opens(token)) {
            if (open.size() >= max_bracket_depth)
                fail("PG021", token.at, "brackets are nested more than 256 deep; use variables in between");
            open.push_back(at);
        } else if (closes(token)) {
            const Token& opening = effect.tokens[open.back()];
            if (!token.is(partner(opening)))
                fail("PG021", token.at,
                     quoted(token) + " does not close the " + quoted(opening) + " of line " +
                         std::to_string(opening.at.line));
            open.pop_back();
        }
        take();
    } while (!open.empty());
    return {begin + 1, at - 1};
}

TokenRange ParseCursor::skip_to(std::string_view ends, const std::string& what) {
    const std::size_t begin = at;
    while (!(peek().text.size() == 1 && ends.find(peek().text.front()) != std::string_view::npos)) {
        if (done()) fail("PG021", effect.tokens[begin].at, what + " does not end before the file does");
        if (opens(peek()))
            skip_brackets();
        else if (closes(peek()))
            fail("PG020", peek().at, "unexpected " + quoted(peek()) + " in " + what);
        else
            take();
    }
    return {begin, at};
}

void ParseCursor::drop(TokenRange range) {
    for (std::size_t i = range.begin; i < range.end; ++i) effect.dropped[i] = true;
}

std::string quoted(const Token& token) {
    if (token.kind == TokenKind::End) return "the end of the file";
    constexpr std::size_t longest = 60;
    if (token.text.size() > longest) return "'" + std::string(token.text.substr(0, longest)) + "...'";
    return "'" + std::string(token.text) + "'";
}

std::string text_of(const ParsedEffect& effect, TokenRange range) {
    return spelled(std::span(effect.tokens).subspan(range.begin, range.size()));
}

}  // namespace permgen

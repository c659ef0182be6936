// The base of every part of the parser: a position in the tokens, and error reporting.
#pragma once

#include <string>

#include "front/effect.h"

namespace permgen {

/// Thrown at a syntax error, after its diagnostic was added; caught around each item at file scope.
struct SyntaxError {};

struct ParseCursor {
    ParsedEffect& effect;
    const Sources& sources;
    Diagnostics& diagnostics;
    std::size_t at = 0;

    const Token& peek(std::size_t ahead = 0) const {
        const std::size_t index = at + ahead;
        return index < effect.tokens.size() ? effect.tokens[index] : effect.tokens.back();
    }
    bool is(std::string_view spelling) const { return peek().is(spelling); }
    bool done() const { return peek().kind == TokenKind::End; }
    const Token& take() { return effect.tokens[done() ? at : at++]; }
    bool take_if(std::string_view spelling);

    /// Reports the error at the given place and leaves the current item.
    [[noreturn]] void fail(const char* code, Location place, std::string message);

    /// The next token, which must be `spelling`. `where` completes the message: "after the pass's name".
    void expect(std::string_view spelling, const std::string& where);
    const Token& expect_identifier(const std::string& what);

    /// Skips from an opening bracket past its closing one. Returns the tokens between.
    TokenRange skip_brackets();
    /// Skips to one of the characters in `ends` outside brackets, which it does not consume.
    TokenRange skip_to(std::string_view ends, const std::string& what);

    void drop(TokenRange range);
};

/// The token's text for a message: 'text', or "the end of the file".
std::string quoted(const Token& token);

/// The tokens' texts, with a space where the author has one.
std::string text_of(const ParsedEffect& effect, TokenRange range);

}  // namespace permgen

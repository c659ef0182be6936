// Characters to tokens. The lexer knows no macros and no keywords; the preprocessor and the parser handle them.
#pragma once

#include <string_view>
#include <vector>

#include "front/source.h"

namespace permgen {

enum class TokenKind : std::uint8_t { Identifier, Number, String, Punctuator, Unknown, End };

struct Token {
    std::string_view text;
    Location at;
    TokenKind kind = TokenKind::End;
    bool starts_line = false;
    bool follows_space = false;
    bool from_macro = false;  ///< stands in a macro's body, not at `at`
    bool painted = false;     ///< named a macro inside its own expansion: never expanded again

    bool is(std::string_view spelling) const { return kind != TokenKind::String && text == spelling; }
    bool is_identifier() const { return kind == TokenKind::Identifier; }
};

using Tokens = std::vector<Token>;

/// The file's tokens, without comments and without an End token. `name` becomes their Location::file. A byte that
/// cannot start a token becomes an Unknown token, so that text which a condition skips causes no error. The only error
/// here is a comment without an end.
Tokens lex(const SourceFile& source, std::int32_t name, const Sources& sources, Diagnostics& diagnostics);

/// A string token's characters without the quotes.
std::string_view unquoted(const Token& token);

}  // namespace permgen

// Characters to tokens. No macro, no keyword: the preprocessor and the parser give words their meaning.
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
    bool from_macro = false;  ///< stands in a macro's body, not where `at` says
    bool painted = false;     ///< named a macro inside its own expansion: never expanded again

    bool is(std::string_view spelling) const { return kind != TokenKind::String && text == spelling; }
    bool is_identifier() const { return kind == TokenKind::Identifier; }
};

using Tokens = std::vector<Token>;

/// The file's tokens without comments, no End token behind them. `name` is the Location::file to put into
/// them. A byte that starts no token becomes an Unknown token, so that text which a condition skips
/// causes no error; only a comment without an end is reported here.
Tokens lex(const SourceFile& source, std::int32_t name, const Sources& sources, Diagnostics& diagnostics);

/// A string token's characters without the quotes.
std::string_view unquoted(const Token& token);

}  // namespace permgen

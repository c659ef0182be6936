// An effect's text, parsed and lowered.
#pragma once

#include <string>
#include <string_view>

#include "front/parse.h"
#include "lower/lower.h"

namespace permgen::test {

struct LoweredEffect {
    Sources sources;
    Diagnostics diagnostics;
    Lowered lowered;

    explicit LoweredEffect(std::string_view text) {
        sources.files.push_back(make_source("t.fx", text));
        const std::int32_t name = sources.name_index("t.fx");
        Tokens tokens = lex(sources.files.back(), name, sources, diagnostics);
        Token end;
        end.at = {name, 999, 1};
        tokens.push_back(end);
        const ParsedEffect effect = parse(std::move(tokens), sources, diagnostics);
        if (!has_errors(diagnostics)) lowered = lower(effect, sources, diagnostics);
    }

    std::string messages() const {
        std::string text;
        for (const Diagnostic& diagnostic : diagnostics) text += format(diagnostic) + '\n';
        return text;
    }
};

}  // namespace permgen::test

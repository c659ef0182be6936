#include "lower/calls.h"

#include <algorithm>
#include <array>

namespace permgen {

std::vector<Call> find_calls(const ParsedEffect& effect) {
    std::vector<Call> calls;
    for (std::size_t f = 0; f < effect.functions.size(); ++f) {
        const TokenRange body = effect.functions[f].body;
        for (std::size_t i = body.begin; i + 1 < body.end; ++i) {
            if (!effect.tokens[i].is_identifier() || !effect.tokens[i + 1].is("(")) continue;
            Call call{f, i, {}};
            std::size_t first = i + 2;
            int depth = 0;
            for (std::size_t k = first; k < body.end; ++k) {
                const Token& token = effect.tokens[k];
                const bool ends = depth == 0 && (token.is(",") || token.is(")"));
                if (ends) {
                    call.arguments.push_back({first, k});
                    first = k + 1;
                }
                if (token.is("(") || token.is("[")) ++depth;
                if ((token.is(")") || token.is("]")) && --depth < 0) break;
            }
            calls.push_back(std::move(call));
        }
    }
    return calls;
}

std::vector<bool> reachable_functions(const ParsedEffect& effect, const std::vector<Call>& calls,
                                      const Function& entry) {
    std::vector<bool> reached(effect.functions.size(), false);
    reached[static_cast<std::size_t>(&entry - effect.functions.data())] = true;
    for (bool changed = true; changed;) {
        changed = false;
        for (const Call& call : calls) {
            if (!reached[call.caller]) continue;
            for (std::size_t f = 0; f < effect.functions.size(); ++f) {
                if (reached[f] || effect.functions[f].name != effect.tokens[call.name_token].text) continue;
                reached[f] = changed = true;
            }
        }
    }
    return reached;
}

bool is_shadowed(const ParsedEffect& effect, const Function& function, std::string_view name) {
    for (const Variable& parameter : function.parameters)
        if (parameter.name == name) return true;
    // Two words in a row declare the second one, unless the first is a statement's.
    static constexpr std::array<std::string_view, 4> statements = {"return", "else", "do", "case"};
    for (std::size_t i = function.body.begin + 1; i < function.body.end; ++i) {
        const Token& before = effect.tokens[i - 1];
        if (effect.tokens[i].text == name && before.is_identifier() &&
            std::find(statements.begin(), statements.end(), before.text) == statements.end())
            return true;
    }
    return false;
}

bool names_global(const ParsedEffect& effect, const Function& function, std::size_t token) {
    const Token& word = effect.tokens[token];
    return word.is_identifier() && !effect.tokens[token - 1].is(".") && !is_shadowed(effect, function, word.text);
}

}  // namespace permgen

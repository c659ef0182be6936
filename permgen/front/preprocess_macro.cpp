#include "front/preprocess_macro.h"

#include <algorithm>
#include <optional>

#include "front/preprocess.h"
#include "front/report.h"

namespace permgen {
namespace {

// Longest token that # and ## may build. Nested # doubles its backslashes at every level: without a limit, a few lines
// could need exabytes.
constexpr std::size_t max_built_token = 1u << 16;

struct Frame {
    std::span<const Token> tokens;
    Tokens owned;
    std::size_t next = 0;
    Macro* macro = nullptr;
};

class Expander {
public:
    Expander(MacroContext& context, std::span<const Token> input, int depth, Tokens& out)
        : context_(context), depth_(depth), out_(out) {
        frames_.push_back({input, {}, 0, nullptr});
    }

    void run() {
        while (const std::optional<Token> token = take()) {
            spend(context_, 1, token->at);
            if (!token->is_identifier() || token->painted || !expand_name(*token)) emit(*token);
        }
    }

private:
    void emit(const Token& token) {
        if (out_.size() >= max_output_tokens) {
            complain(context_, "PG009", token.at,
                     "the macros expand to more than 1048576 tokens; look for one that grows with every use");
            throw PreprocessingAborted();
        }
        out_.push_back(token);
    }

    // Leaves the exhausted expansions; nullptr at the very end.
    Frame* frame_with_token() {
        while (frames_.back().next >= frames_.back().tokens.size()) {
            if (frames_.size() == 1) return nullptr;
            if (frames_.back().macro) frames_.back().macro->in_use = false;
            frames_.pop_back();
        }
        return &frames_.back();
    }

    std::optional<Token> take() {
        Frame* frame = frame_with_token();
        if (!frame) return std::nullopt;
        return frame->tokens[frame->next++];
    }

    bool next_is(std::string_view spelling) {
        const Frame* frame = frame_with_token();
        return frame && frame->tokens[frame->next].is(spelling);
    }

    bool expand_name(const Token& name) {
        if (name.text == "__LINE__" || name.text == "__FILE__") {
            emit(built_in(name));
            return true;
        }
        const auto found = context_.macros.find(name.text);
        if (found == context_.macros.end()) return false;
        Macro& macro = found->second;
        if (macro.in_use) {
            Token painted = name;
            painted.painted = true;
            emit(painted);
            return true;
        }
        std::vector<Tokens> arguments;
        if (macro.function_like) {
            if (!next_is("(")) return false;
            take();
            if (!collect_arguments(name, macro, arguments)) return true;
        }
        push(name, macro, substitute(name, macro, arguments));
        return true;
    }

    Token built_in(const Token& name) {
        Token token = name;
        const SourceLocation place = context_.sources.place(name.at);
        if (name.text == "__LINE__") {
            token.kind = TokenKind::Number;
            token.text = context_.sources.keep(std::to_string(place.line));
        } else {
            token.kind = TokenKind::String;
            token.text = context_.sources.keep('"' + place.file + '"');
        }
        return token;
    }

    // After the '(': everything up to its ')', split at the commas outside inner parentheses.
    bool collect_arguments(const Token& name, const Macro& macro, std::vector<Tokens>& arguments) {
        const std::size_t expected = macro.parameters.size();
        arguments.emplace_back();
        int nesting = 0;
        while (true) {
            const std::optional<Token> token = take();
            if (!token) {
                complain(context_, "PG010", name.at,
                         "the arguments of macro '" + std::string(name.text) +
                             "' have no closing ')' before the next directive or the end of the file");
                return false;
            }
            spend(context_, 1, token->at);
            if (token->is("(")) ++nesting;
            if (token->is(")") && nesting-- == 0) break;
            const bool rest_is_variadic = macro.variadic && arguments.size() == expected;
            if (token->is(",") && nesting == 0 && !rest_is_variadic)
                arguments.emplace_back();
            else
                arguments.back().push_back(*token);
        }
        if (macro.variadic && arguments.size() + 1 == expected) arguments.emplace_back();
        if (expected == 0 && arguments.size() == 1 && arguments[0].empty()) arguments.clear();
        if (arguments.size() != expected) {
            complain(context_, "PG010", name.at,
                     "macro '" + std::string(name.text) + "' takes " + std::to_string(expected) + " argument(s), not " +
                         std::to_string(arguments.size()));
            return false;
        }
        return true;
    }

    void push(const Token& name, Macro& macro, Tokens body) {
        if (!body.empty()) {
            body.front().starts_line = name.starts_line;
            body.front().follows_space = name.follows_space;
        }
        frames_.push_back({{}, std::move(body), 0, &macro});
        frames_.back().tokens = frames_.back().owned;
        macro.in_use = true;
    }

    Tokens substitute(const Token& name, const Macro& macro, const std::vector<Tokens>& arguments) {
        Tokens result;
        std::vector<std::optional<Tokens>> expanded(arguments.size());
        bool pasting = false;
        bool left_is_empty = true;
        const auto append = [&](std::span<const Token> piece) {
            spend(context_, piece.size(), name.at);
            if (pasting && !left_is_empty) {
                if (!piece.empty()) {
                    result.back() = paste(result.back(), piece.front());
                    result.insert(result.end(), piece.begin() + 1, piece.end());
                }
            } else {
                result.insert(result.end(), piece.begin(), piece.end());
                left_is_empty = piece.empty();
            }
            pasting = false;
        };
        for (std::size_t i = 0; i < macro.body.size(); ++i) {
            Token token = macro.body[i];
            token.at = name.at;
            token.from_macro = true;
            if (token.is("##") && i > 0 && i + 1 < macro.body.size()) {
                pasting = true;
                continue;
            }
            if (macro.function_like && token.is("#") && i + 1 < macro.body.size()) {
                if (const auto index = parameter_index(macro, macro.body[i + 1])) {
                    const Token string = stringized(token, arguments[*index]);
                    append({&string, 1});
                    ++i;
                    continue;
                }
            }
            const std::optional<std::size_t> index = parameter_index(macro, token);
            if (!index) {
                append({&token, 1});
                continue;
            }
            const bool pasted = pasting || (i + 1 < macro.body.size() && macro.body[i + 1].is("##"));
            if (pasted) {
                append(arguments[*index]);
                continue;
            }
            if (!expanded[*index]) {
                if (depth_ + 1 > max_argument_depth) {
                    complain(context_, "PG009", name.at, "macro calls are nested more than 64 deep in arguments");
                    throw PreprocessingAborted();
                }
                expanded[*index].emplace();
                expand(context_, arguments[*index], depth_ + 1, *expanded[*index]);
            }
            append(*expanded[*index]);
        }
        return result;
    }

    static std::optional<std::size_t> parameter_index(const Macro& macro, const Token& token) {
        if (!macro.function_like || !token.is_identifier()) return std::nullopt;
        const auto found = std::find(macro.parameters.begin(), macro.parameters.end(), token.text);
        if (found == macro.parameters.end()) return std::nullopt;
        return static_cast<std::size_t>(found - macro.parameters.begin());
    }

    void check_length(std::size_t length, Location at) {
        spend(context_, 16 + length / 16, at);
        if (length <= max_built_token) return;
        complain(context_, "PG009", at, "a macro builds a token of more than 65536 characters with # or ##");
        throw PreprocessingAborted();
    }

    Token stringized(const Token& at, const Tokens& argument) {
        std::string text = "\"";
        for (const Token& token : argument) {
            if (&token != &argument.front() && token.follows_space) text += ' ';
            for (const char c : token.text) {
                if (token.kind == TokenKind::String && (c == '"' || c == '\\')) text += '\\';
                text += c;
            }
            check_length(text.size(), at.at);
        }
        Token string = at;
        string.kind = TokenKind::String;
        string.text = context_.sources.keep(text + '"');
        return string;
    }

    Token paste(const Token& left, const Token& right) {
        check_length(left.text.size() + right.text.size(), left.at);
        std::string text = std::string(left.text) + std::string(right.text);
        context_.sources.files.push_back(make_source({}, text));
        Diagnostics ignored;
        const Tokens pasted = lex(context_.sources.files.back(), left.at.file, context_.sources, ignored);
        Token token = left;
        if (pasted.size() != 1 || pasted[0].kind == TokenKind::Unknown) {
            complain(context_, "PG010", left.at, "'##' makes '" + text + "', which is not one token");
            return token;
        }
        token.text = pasted[0].text;
        token.kind = pasted[0].kind;
        token.painted = false;
        return token;
    }

    MacroContext& context_;
    int depth_;
    Tokens& out_;
    std::vector<Frame> frames_;
};

}  // namespace

void spend(MacroContext& context, std::size_t steps, Location at) {
    context.steps += steps;
    if (context.steps <= max_preprocessing_steps) return;
    report_error(context.diagnostics, "PG009", context.sources.place(at),
                 "preprocessing takes too many steps; look for macros or includes that double with every use");
    throw PreprocessingAborted();
}

void complain(MacroContext& context, const char* code, Location at, std::string message) {
    report_error(context.diagnostics, code, context.sources.place(at), std::move(message));
    if (context.diagnostics.size() >= max_reported_errors) throw PreprocessingAborted();
}

void expand(MacroContext& context, std::span<const Token> input, int depth, Tokens& out) {
    Expander(context, input, depth, out).run();
}

std::string spelled(std::span<const Token> tokens) {
    std::string text;
    for (const Token& token : tokens) {
        if (!text.empty() && token.follows_space) text += ' ';
        text += token.text;
    }
    return text;
}

}  // namespace permgen

#include "front/preprocess.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include "common/nearest.h"
#include "front/preprocess_expression.h"
#include "front/preprocess_macro.h"
#include "front/report.h"

namespace permgen {
namespace {

struct Conditional {
    Location at;
    bool outer_active;
    bool active;
    bool taken;  ///< one of its branches has been active
    bool in_else;
};

// The effect of #line on the rest of a file.
struct LineShift {
    std::int64_t lines = 0;
    std::int32_t file = -1;  ///< -1: the file's own name
};

class Preprocessor {
public:
    Preprocessor(const SourceOptions& options, Sources& sources, Diagnostics& diagnostics)
        : options_(options), context_{sources, diagnostics, {}, 0} {}

    Preprocessed run(const std::string& path) {
        Location end;
        try {
            define_from_options();
            if (const Tokens* tokens = open(path, Location{})) {
                end = {context_.sources.name_index(path), 1, 1};
                if (!tokens->empty()) end = tokens->back().at;
                process(path, *tokens, 1);
            }
        } catch (const PreprocessingAborted&) {
        }
        Token last;
        last.at = end;
        last.starts_line = true;
        result_.tokens.push_back(last);
        return std::move(result_);
    }

private:
    void complain(const char* code, Location at, std::string message) {
        permgen::complain(context_, code, at, std::move(message));
    }

    void define_from_options() {
        std::vector<std::pair<std::string, std::string>> defines = options_.defines;
        defines.insert(defines.begin(), {"PERMGEN", "1"});
        for (const auto& [name, value] : defines) {
            context_.sources.files.push_back(make_source("command line", name + " " + value));
            Tokens tokens = lex(context_.sources.files.back(), context_.sources.name_index("command line"),
                                context_.sources, context_.diagnostics);
            if (tokens.empty() || !tokens[0].is_identifier() || tokens[0].text != name) {
                complain("PG008", Location{}, "'" + name + "' cannot be defined; a macro's name is an identifier");
                continue;
            }
            Macro macro;
            macro.body.assign(tokens.begin() + 1, tokens.end());
            context_.macros.insert_or_assign(tokens[0].text, std::move(macro));
        }
    }

    // The file's tokens. A file that is included again is not read again.
    const Tokens* open(const std::string& path, Location from) {
        const auto known = files_.find(path);
        if (known != files_.end()) return &known->second;
        std::string reason;
        const std::optional<std::string> bytes = read_bytes(path, reason);
        if (!bytes) {
            if (from.file < 0) from.file = context_.sources.name_index(path);
            complain("PG001", from, "cannot read '" + path + "': " + reason);
            return nullptr;
        }
        result_.dependencies.push_back(path);
        context_.sources.files.push_back(make_source(path, *bytes));
        Tokens tokens = lex(context_.sources.files.back(), context_.sources.name_index(path), context_.sources,
                            context_.diagnostics);
        return &files_.emplace(path, std::move(tokens)).first->second;
    }

    void process(const std::string& path, const Tokens& tokens, int depth) {
        const std::size_t outer_conditionals = conditionals_.size();
        const LineShift outer_shift = shift_;
        shift_ = {};
        std::size_t i = 0;
        while (i < tokens.size()) {
            const bool directive = tokens[i].starts_line && tokens[i].is("#");
            std::size_t end = i + 1;
            while (end < tokens.size() && !(tokens[end].starts_line && (directive || tokens[end].is("#")))) ++end;
            const Tokens text(tokens.begin() + static_cast<std::ptrdiff_t>(i),
                              tokens.begin() + static_cast<std::ptrdiff_t>(end));
            spend(context_, text.size(), text.front().at);
            if (directive)
                run_directive(path, shifted(text), outer_conditionals, depth);
            else if (active())
                emit_text(shifted(text));
            i = end;
        }
        while (conditionals_.size() > outer_conditionals) {
            complain("PG006", conditionals_.back().at, "this condition has no #endif");
            conditionals_.pop_back();
        }
        shift_ = outer_shift;
    }

    bool active() const { return conditionals_.empty() || conditionals_.back().active; }

    Tokens shifted(Tokens tokens) const {
        if (shift_.lines == 0 && shift_.file < 0) return tokens;
        for (Token& token : tokens) {
            const std::int64_t line = token.at.line + shift_.lines;
            token.at.line =
                static_cast<std::int32_t>(std::clamp<std::int64_t>(line, 1, std::numeric_limits<std::int32_t>::max()));
            if (shift_.file >= 0) token.at.file = shift_.file;
        }
        return tokens;
    }

    void emit_text(const Tokens& text) {
        const std::size_t first = result_.tokens.size();
        expand(context_, text, 0, result_.tokens);
        for (std::size_t i = first; i < result_.tokens.size(); ++i) {
            const Token& token = result_.tokens[i];
            if (token.kind == TokenKind::Unknown) complain_about_byte(token);
        }
    }

    void complain_about_byte(const Token& token) {
        const auto byte = static_cast<unsigned char>(token.text.front());
        std::string what = "'" + std::string(token.text) + "'";
        if (byte == '"') {
            complain("PG004", token.at, "this string has no closing '\"' on its line");
            return;
        }
        if (byte < 0x20 || byte >= 0x7F) {
            constexpr char digits[] = "0123456789ABCDEF";
            what = std::string("the byte 0x") + digits[byte >> 4] + digits[byte & 15];
        }
        complain("PG004", token.at, what + " has no meaning in HLSL outside comments and strings; remove it");
    }

    void run_directive(const std::string& path, const Tokens& line, std::size_t outer_conditionals, int depth) {
        if (line.size() < 2) return;
        const Token& name = line[1];
        const std::span<const Token> rest = std::span(line).subspan(2);
        if (name.is("if") || name.is("ifdef") || name.is("ifndef")) return open_conditional(name, rest);
        if (name.is("elif") || name.is("else") || name.is("endif")) {
            if (conditionals_.size() == outer_conditionals)
                return complain("PG006", name.at, "#" + std::string(name.text) + " without an #if in this file");
            return continue_conditional(name, rest);
        }
        if (!active()) return;
        if (name.is("define")) return define(name, rest);
        if (name.is("undef")) return undefine(name, rest);
        if (name.is("include")) return include(path, name, rest, depth);
        if (name.is("line")) return set_line(name, rest);
        if (name.is("pragma")) return pragma(rest, name);
        if (name.is("error")) return complain("PG005", name.at, "#error " + spelled(rest));
        if (name.is("warning"))
            return report_warning(context_.diagnostics, "PG005", context_.sources.place(name.at),
                                  "#warning " + spelled(rest));
        static constexpr std::string_view known[] = {"if",     "ifdef",  "ifndef", "elif",    "else",
                                                     "endif",  "define", "undef",  "include", "line",
                                                     "pragma", "error",  "warning"};
        complain("PG007", name.at,
                 "unknown directive '#" + std::string(name.text) + "'" +
                     suggestion(name.text, known, "; did you mean '#", "'?"));
    }

    void open_conditional(const Token& name, std::span<const Token> rest) {
        if (conditionals_.size() >= 1024) {
            complain("PG006", name.at, "conditions are nested more than 1024 deep");
            throw PreprocessingAborted();
        }
        Conditional conditional{name.at, active(), false, false, false};
        if (conditional.outer_active) {
            if (name.is("if"))
                conditional.active = condition(name, rest);
            else if (rest.size() != 1 || !rest[0].is_identifier())
                complain("PG006", name.at, "#" + std::string(name.text) + " needs exactly one macro name");
            else
                conditional.active = defined(rest[0]) == name.is("ifdef");
        }
        conditional.taken = conditional.active;
        conditionals_.push_back(conditional);
    }

    void continue_conditional(const Token& name, std::span<const Token> rest) {
        Conditional& conditional = conditionals_.back();
        if (name.is("endif")) {
            conditionals_.pop_back();
            return;
        }
        if (conditional.in_else)
            return complain("PG006", name.at, "#" + std::string(name.text) + " after the #else of the same #if");
        conditional.active = false;
        if (name.is("else")) {
            conditional.in_else = true;
            conditional.active = conditional.outer_active && !conditional.taken;
        } else if (conditional.outer_active && !conditional.taken) {
            conditional.active = condition(name, rest);
        }
        conditional.taken = conditional.taken || conditional.active;
    }

    bool defined(const Token& name) const {
        return context_.macros.contains(name.text) || name.is("__LINE__") || name.is("__FILE__");
    }

    bool condition(const Token& name, std::span<const Token> rest) {
        Tokens without_defined;
        for (std::size_t i = 0; i < rest.size(); ++i) {
            Token token = rest[i];
            if (token.is("defined")) {
                const bool parenthesis = i + 1 < rest.size() && rest[i + 1].is("(");
                const std::size_t at = i + (parenthesis ? 2 : 1);
                const std::size_t last = at + (parenthesis ? 1 : 0);
                if (last >= rest.size() || !rest[at].is_identifier() || (parenthesis && !rest[last].is(")"))) {
                    complain("PG006", token.at, "write defined(NAME) or defined NAME");
                    return false;
                }
                token.kind = TokenKind::Number;
                token.text = defined(rest[at]) ? "1" : "0";
                i = last;
            }
            without_defined.push_back(token);
        }
        Tokens expanded;
        expand(context_, without_defined, 0, expanded);
        // As in C, a name that is not a macro counts as 0, except `true`, which counts as 1.
        const IntegerNames names = [](std::string_view word) { return word == "true" ? 1 : 0; };
        const IntegerResult result = evaluate_integer(expanded, names);
        if (result.value) return *result.value != 0;
        complain("PG006", result.at.file >= 0 ? result.at : name.at,
                 "the condition of #" + std::string(name.text) + " has no value: " + result.problem);
        return false;
    }

    void define(const Token& directive, std::span<const Token> rest) {
        if (rest.empty() || !rest[0].is_identifier() || rest[0].is("defined"))
            return complain("PG008", directive.at, "#define needs a macro name that is an identifier");
        const Token& name = rest[0];
        Macro macro;
        macro.at = name.at;
        std::size_t body = 1;
        if (rest.size() > 1 && rest[1].is("(") && !rest[1].follows_space) {
            macro.function_like = true;
            body = 2;
            while (body < rest.size() && !rest[body].is(")")) {
                const Token& parameter = rest[body];
                if (parameter.is("...")) {
                    macro.variadic = true;
                    macro.parameters.push_back("__VA_ARGS__");
                } else if (parameter.is_identifier()) {
                    macro.parameters.push_back(parameter.text);
                } else {
                    return complain("PG008", parameter.at,
                                    "expected a parameter name of macro '" + std::string(name.text) + "'");
                }
                ++body;
                if (body < rest.size() && rest[body].is(",") && !macro.variadic)
                    ++body;
                else
                    break;
            }
            if (body >= rest.size() || !rest[body].is(")"))
                return complain("PG008", name.at,
                                "the parameters of macro '" + std::string(name.text) + "' have no closing ')'");
            ++body;
        }
        macro.body.assign(rest.begin() + static_cast<std::ptrdiff_t>(body), rest.end());
        for (Token& token : macro.body) token.starts_line = false;
        const auto known = context_.macros.find(name.text);
        if (known != context_.macros.end() && !same(known->second, macro))
            report_warning(
                context_.diagnostics, "PG008", context_.sources.place(name.at),
                "macro '" + std::string(name.text) + "' is defined again with another meaning; #undef it first");
        context_.macros.insert_or_assign(name.text, std::move(macro));
    }

    static bool same(const Macro& a, const Macro& b) {
        return a.function_like == b.function_like && a.parameters == b.parameters &&
               std::equal(a.body.begin(), a.body.end(), b.body.begin(), b.body.end(),
                          [](const Token& x, const Token& y) { return x.text == y.text; });
    }

    void undefine(const Token& directive, std::span<const Token> rest) {
        if (rest.size() != 1 || !rest[0].is_identifier())
            return complain("PG008", directive.at, "#undef needs exactly one macro name");
        context_.macros.erase(rest[0].text);
    }

    // The name between quotes or angle brackets; macros are expanded first if it has neither.
    std::optional<std::string> include_name(std::span<const Token> rest) {
        Tokens expanded(rest.begin(), rest.end());
        if (!expanded.empty() && expanded[0].is_identifier()) {
            expanded.clear();
            expand(context_, rest, 0, expanded);
        }
        std::string name;
        if (expanded.size() == 1 && expanded[0].kind == TokenKind::String) {
            name = unquoted(expanded[0]);
        } else if (expanded.size() > 2 && expanded.front().is("<") && expanded.back().is(">")) {
            name = spelled(std::span(expanded).subspan(1, expanded.size() - 2));
        }
        if (name.empty() || name.find('\0') != std::string::npos) return std::nullopt;
        std::replace(name.begin(), name.end(), '\\', '/');  // Effects come from Windows.
        return name;
    }

    void include(const std::string& path, const Token& directive, std::span<const Token> rest, int depth) {
        const std::optional<std::string> name = include_name(rest);
        if (!name) return complain("PG002", directive.at, "write #include \"FILE\" or #include <FILE>");
        if (depth >= max_include_depth) {
            complain("PG002", directive.at,
                     "'" + *name +
                         "' is included more than 64 levels deep; a file that includes itself needs "
                         "#pragma once or an #ifndef around it");
            throw PreprocessingAborted();
        }
        spend(context_, steps_of_include, directive.at);
        std::vector<std::filesystem::path> folders{std::filesystem::path(path).parent_path()};
        folders.insert(folders.end(), options_.include_folders.begin(), options_.include_folders.end());
        std::string searched;
        for (const std::filesystem::path& folder : folders) {
            const std::string candidate = (folder / *name).lexically_normal().string();
            std::error_code error;
            if (!std::filesystem::is_regular_file(candidate, error)) {
                searched += (searched.empty() ? "'" : ", '") + (folder.empty() ? "." : folder.string()) + "'";
                continue;
            }
            if (std::find(included_once_.begin(), included_once_.end(), candidate) != included_once_.end()) return;
            const LineShift shift = shift_;
            if (const Tokens* tokens = open(candidate, directive.at)) process(candidate, *tokens, depth + 1);
            shift_ = shift;
            return;
        }
        complain("PG002", directive.at,
                 "cannot find the include file '" + *name + "' in " + searched + "; name its folder with -I");
    }

    void set_line(const Token& directive, std::span<const Token> rest) {
        Tokens expanded;
        expand(context_, rest, 0, expanded);
        const std::int64_t line = expanded.empty() ? -1 : integer_literal(expanded[0].text).value_or(-1);
        const bool has_name = expanded.size() == 2 && expanded[1].kind == TokenKind::String;
        if (line < 0 || line > std::numeric_limits<std::int32_t>::max() || (expanded.size() != 1 && !has_name))
            return complain("PG007", directive.at, "write #line NUMBER or #line NUMBER \"FILE\"");
        // The directive's own line, as already shifted, is followed by line `line`.
        shift_.lines += line - (static_cast<std::int64_t>(directive.at.line) + 1);
        if (has_name) shift_.file = context_.sources.name_index(unquoted(expanded[1]));
    }

    void pragma(std::span<const Token> rest, const Token& directive) {
        if (rest.empty()) return;
        if (rest[0].is("once") && !shift_active()) {
            included_once_.push_back(context_.sources.place(directive.at).file);
        } else if (rest[0].is("pack_matrix")) {
            complain("PG007", directive.at,
                     "#pragma pack_matrix is not supported; write row_major or column_major on the declarations");
        }
    }

    bool shift_active() const { return shift_.file >= 0; }

    const SourceOptions& options_;
    MacroContext context_;
    Preprocessed result_;
    std::unordered_map<std::string, Tokens> files_;
    std::vector<Conditional> conditionals_;
    std::vector<std::string> included_once_;
    LineShift shift_;
};

}  // namespace

Preprocessed preprocess(const std::string& path, const SourceOptions& options, Sources& sources,
                        Diagnostics& diagnostics) {
    return Preprocessor(options, sources, diagnostics).run(path);
}

}  // namespace permgen

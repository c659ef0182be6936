#include "lower/lower_arguments.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

#include "common/nearest.h"
#include "front/parse_cursor.h"
#include "front/preprocess_expression.h"
#include "front/report.h"
#include "lower/lower_text.h"
#include "lower/lower_types.h"

namespace permgen {
namespace {

const char* article(ScalarType type) {
    static constexpr const char* names[] = {"a bool", "an int", "a uint", "a float"};
    return names[static_cast<int>(type)];
}

std::optional<float> float_literal(std::string_view text) {
    while (!text.empty() && std::string_view("fFhHlL").find(text.back()) != std::string_view::npos)
        text.remove_suffix(1);
    if (text.find_first_of(".eE") == std::string_view::npos) return std::nullopt;
    if (text.starts_with("0x") || text.starts_with("0X")) return std::nullopt;
    float value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || (error != std::errc() && error != std::errc::result_out_of_range))
        return std::nullopt;
    if (error == std::errc::result_out_of_range) {
        // Too large or too small: the exponent's sign decides which. Too small becomes 0.
        value = text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos
                    ? 0.0F
                    : std::numeric_limits<float>::infinity();
    }
    return value;
}

// A literal without its signs and enclosing parentheses.
struct BareLiteral {
    std::span<const Token> tokens;
    bool negative = false;
    bool has_sign = false;
};

BareLiteral bare(std::span<const Token> tokens) {
    BareLiteral literal{tokens};
    while (literal.tokens.size() > 1) {
        const Token& first = literal.tokens.front();
        if (first.is("(") && literal.tokens.back().is(")")) {
            literal.tokens = literal.tokens.subspan(1, literal.tokens.size() - 2);
        } else if (first.is("-") || first.is("+")) {
            literal.has_sign = true;
            literal.negative ^= first.is("-");
            literal.tokens = literal.tokens.subspan(1);
        } else {
            break;
        }
    }
    return literal;
}

class Binder {
public:
    Binder(const ParsedEffect& effect, const Sources& sources, const Compile& compile, Diagnostics& diagnostics)
        : effect_(effect), sources_(sources), compile_(compile), diagnostics_(diagnostics) {}

    std::optional<BoundEntry> run() {
        const Function* function = find_entry();
        if (!function) return std::nullopt;
        BoundEntry bound{function, {}};
        std::vector<const Variable*> parameters;
        for (const Variable& parameter : function->parameters)
            if (is_uniform_parameter(parameter)) parameters.push_back(&parameter);
        std::size_t required = parameters.size();
        while (required > 0 && !parameters[required - 1]->initializer.empty()) --required;
        const std::size_t given = compile_.arguments.size();
        if (given < required || given > parameters.size()) {
            error("PG031", compile_.entry_at, count_message(*function, parameters, given));
            return std::nullopt;
        }
        bool good = true;
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const TokenRange range = i < given ? compile_.arguments[i] : parameters[i]->initializer;
            if (range.empty()) {
                error("PG032", compile_.entry_at,
                      "argument " + std::to_string(i + 1) + " of '" + std::string(function->name) + "' is empty");
                good = false;
                continue;
            }
            const std::optional<BoundParameter> parameter = bind(*parameters[i], range);
            good = good && parameter;
            if (parameter) bound.uniforms.push_back(*parameter);
        }
        if (!good) return std::nullopt;
        return bound;
    }

private:
    void error(const char* code, Location at, std::string message) {
        report_error(diagnostics_, code, sources_.place(at), std::move(message));
    }

    const Function* find_entry() {
        const Function* found = nullptr;
        std::vector<std::string_view> names;
        for (const Function& function : effect_.functions) {
            names.push_back(function.name);
            if (function.name != compile_.entry || function.body.empty()) continue;
            if (found) {
                error("PG030", compile_.entry_at,
                      "'" + std::string(compile_.entry) + "' is overloaded; an entry point needs a unique name");
                return nullptr;
            }
            found = &function;
        }
        if (!found)
            error("PG030", compile_.entry_at,
                  "there is no function '" + std::string(compile_.entry) + "' to compile" +
                      suggestion(compile_.entry, names, "; did you mean '", "'?"));
        return found;
    }

    std::string count_message(const Function& function, const std::vector<const Variable*>& parameters,
                              std::size_t given) const {
        std::string message = "'" + std::string(function.name) + "' has " + std::to_string(parameters.size()) +
                              " uniform parameter(s), but this compile gives " + std::to_string(given);
        for (std::size_t i = 0; i < parameters.size(); ++i)
            message += (i == 0 ? "; it expects (" : ", ") + text_of(effect_, parameters[i]->type.range) + ' ' +
                       std::string(parameters[i]->name);
        return message + (parameters.empty() ? "" : ")");
    }

    std::optional<BoundParameter> bind(const Variable& parameter, TokenRange range) {
        const auto tokens = std::span<const Token>(effect_.tokens).subspan(range.begin, range.size());
        BoundParameter bound;
        bound.parameter = &parameter;
        bound.at = tokens.front().at;
        const std::optional<NumericType> type = numeric_type(effect_, parameter.type);
        const std::string name = "'" + std::string(parameter.name) + "'";
        if (type && type->is_scalar() && parameter.dimensions.empty()) {
            bound.type = type->scalar;
            std::string problem;
            if (const auto bits = literal_bits(tokens, type->scalar, problem)) {
                bound.is_axis = true;
                bound.bits = *bits;
                return bound;
            }
            if (!problem.empty()) {
                error("PG032", bound.at,
                      "'" + text_of(effect_, range) + "' " + problem + "; parameter " + name + " of '" +
                          std::string(compile_.entry) + "' is " + article(type->scalar));
                return std::nullopt;
            }
        }
        if (!check_names(tokens, parameter, type)) return std::nullopt;
        bound.expression = hlsl_text(effect_, range);
        return bound;
    }

    // In an argument that is not a literal, every word must be a global or a type; a lone global must also fit.
    bool check_names(std::span<const Token> tokens, const Variable& parameter, const std::optional<NumericType>& type) {
        std::vector<std::string_view> globals;
        for (const Variable& global : effect_.globals)
            if (!global.qualifiers.groupshared) globals.push_back(global.name);
        for (const Sampler& sampler : effect_.samplers) globals.push_back(sampler.name);
        for (const ConstantBuffer& buffer : effect_.constant_buffers)
            for (const Variable& member : buffer.members) globals.push_back(member.name);
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            const Token& token = tokens[i];
            if (!token.is_identifier() || token.is("true") || token.is("false")) continue;
            const bool behind_dot = i > 0 && tokens[i - 1].is(".");
            TypeName as_type;
            as_type.name = token.text;
            if (behind_dot || numeric_type(effect_, as_type)) continue;
            if (std::find(globals.begin(), globals.end(), token.text) == globals.end()) {
                error("PG033", token.at,
                      "'" + std::string(token.text) + "' for parameter '" + std::string(parameter.name) +
                          "' is neither a literal nor a global" +
                          suggestion(token.text, globals, "; did you mean '", "'?"));
                return false;
            }
            if (tokens.size() == 1) return check_global(token, parameter, type);
        }
        if (is_sampler(parameter.type)) {
            error("PG032", tokens.front().at, "parameter '" + std::string(parameter.name) + "' needs a sampler's name");
            return false;
        }
        return true;
    }

    bool check_global(const Token& name, const Variable& parameter, const std::optional<NumericType>& type) {
        bool fits = true;
        const bool wants_sampler = is_sampler(parameter.type);
        for (const Sampler& sampler : effect_.samplers)
            if (sampler.name == name.text) fits = wants_sampler;
        const auto check = [&](const Variable& global) {
            if (global.name != name.text) return;
            const std::optional<NumericType> given = numeric_type(effect_, global.type);
            fits = !wants_sampler && given.has_value() == type.has_value() &&
                   (!type || (given->rows == type->rows && given->columns == type->columns)) &&
                   global.dimensions.size() == parameter.dimensions.size();
        };
        for (const Variable& global : effect_.globals) check(global);
        for (const ConstantBuffer& buffer : effect_.constant_buffers)
            for (const Variable& member : buffer.members) check(member);
        if (!fits)
            error("PG032", name.at,
                  "global '" + std::string(name.text) + "' does not have the type of parameter '" +
                      std::string(parameter.name) + "', " + text_of(effect_, parameter.type.range));
        return fits;
    }

    const ParsedEffect& effect_;
    const Sources& sources_;
    const Compile& compile_;
    Diagnostics& diagnostics_;
};

}  // namespace

bool is_uniform_parameter(const Variable& parameter) {
    return parameter.qualifiers.is_uniform || is_sampler(parameter.type);
}

std::optional<BoundEntry> bind_arguments(const ParsedEffect& effect, const Sources& sources, const Compile& compile,
                                         Diagnostics& diagnostics) {
    return Binder(effect, sources, compile, diagnostics).run();
}

std::optional<std::uint32_t> literal_bits(std::span<const Token> tokens, ScalarType type, std::string& problem) {
    const BareLiteral literal = bare(tokens);
    if (literal.tokens.size() != 1) return std::nullopt;
    const Token& token = literal.tokens.front();
    const bool is_true = token.is("true");
    if (is_true || token.is("false")) {
        if (type == ScalarType::Bool && !literal.has_sign) return is_true ? 1u : 0u;
        problem = "is a bool";
        return std::nullopt;
    }
    if (token.kind != TokenKind::Number) return std::nullopt;
    if (const std::optional<std::int64_t> magnitude = integer_literal(token.text)) {
        const std::int64_t value = literal.negative ? -*magnitude : *magnitude;
        const bool fits = *magnitude >= 0 && *magnitude <= std::numeric_limits<std::uint32_t>::max();
        if (type == ScalarType::Float && fits) return std::bit_cast<std::uint32_t>(static_cast<float>(value));
        if (type == ScalarType::Bool && (value == 0 || value == 1)) return static_cast<std::uint32_t>(value);
        if (type == ScalarType::Int && fits && value >= std::numeric_limits<std::int32_t>::min() &&
            value <= std::numeric_limits<std::int32_t>::max())
            return static_cast<std::uint32_t>(value);
        if (type == ScalarType::Uint && fits && value >= 0) return static_cast<std::uint32_t>(value);
        problem = type == ScalarType::Bool ? "is an int" : "is out of range";
        return std::nullopt;
    }
    if (const std::optional<float> value = float_literal(token.text)) {
        if (type != ScalarType::Float) {
            problem = "is a float";
        } else if (!std::isfinite(*value)) {
            problem = "is out of range";
        } else {
            return std::bit_cast<std::uint32_t>(literal.negative ? -*value : *value);
        }
        return std::nullopt;
    }
    problem = "is not a valid number";
    return std::nullopt;
}

}  // namespace permgen

#include "lower/lower_types.h"

#include <algorithm>
#include <array>
#include <utility>

#include "front/preprocess_expression.h"

namespace permgen {
namespace {

constexpr int max_typedef_depth = 16;
constexpr int max_constant_depth = 16;

std::optional<ScalarType> scalar_type(std::string_view word) {
    static constexpr std::array<std::pair<std::string_view, ScalarType>, 11> words = {{
        {"bool", ScalarType::Bool},
        {"int", ScalarType::Int},
        {"uint", ScalarType::Uint},
        {"dword", ScalarType::Uint},
        {"DWORD", ScalarType::Uint},
        {"float", ScalarType::Float},
        {"half", ScalarType::Float},
        {"min16float", ScalarType::Float},
        {"min10float", ScalarType::Float},
        {"min16int", ScalarType::Int},
        {"min16uint", ScalarType::Uint},
    }};
    for (const auto& [name, type] : words)
        if (name == word) return type;
    return std::nullopt;
}

unsigned dimension(std::string_view text) {
    return text.size() == 1 && text[0] >= '1' && text[0] <= '4' ? static_cast<unsigned>(text[0] - '0') : 0;
}

std::optional<NumericType> named_type(std::string_view name) {
    if (name == "vector") return NumericType{ScalarType::Float, 1, 4, false};
    if (name == "matrix") return NumericType{ScalarType::Float, 4, 4, true};
    if (const auto scalar = scalar_type(name)) return NumericType{*scalar, 1, 1, false};
    const std::size_t size = name.size();
    if (size > 3 && name[size - 2] == 'x' && dimension(name.substr(size - 3, 1)) && dimension(name.substr(size - 1)))
        if (const auto scalar = scalar_type(name.substr(0, size - 3)))
            return NumericType{*scalar, dimension(name.substr(size - 3, 1)), dimension(name.substr(size - 1)), true};
    if (size > 1 && dimension(name.substr(size - 1)))
        if (const auto scalar = scalar_type(name.substr(0, size - 1)))
            return NumericType{*scalar, 1, dimension(name.substr(size - 1)), false};
    return std::nullopt;
}

std::optional<NumericType> numeric_type(const ParsedEffect& effect, const TypeName& type, int depth) {
    if (!type.arguments.empty()) {
        const bool is_matrix = type.name == "matrix";
        const auto scalar = scalar_type(type.arguments[0]);
        if (!scalar || type.arguments.size() > (is_matrix ? 3u : 2u)) return std::nullopt;
        const auto argument = [&](std::size_t i) {
            return i < type.arguments.size() ? dimension(type.arguments[i]) : 4u;
        };
        NumericType result{*scalar, is_matrix ? argument(1) : 1, argument(is_matrix ? 2 : 1), is_matrix};
        if (result.rows == 0 || result.columns == 0) return std::nullopt;
        return result;
    }
    if (const auto named = named_type(type.name)) return named;
    if (depth >= max_typedef_depth) return std::nullopt;
    for (const Typedef& alias : effect.typedefs)
        if (alias.name == type.name) return numeric_type(effect, alias.type, depth + 1);
    return std::nullopt;
}

std::optional<std::int64_t> constant_integer(const ParsedEffect& effect, TokenRange range, int depth) {
    if (depth > max_constant_depth) return std::nullopt;
    const IntegerNames names = [&](std::string_view name) -> std::optional<std::int64_t> {
        for (const Variable& global : effect.globals)
            if (global.name == name && global.qualifiers.is_const && !global.initializer.empty())
                return constant_integer(effect, global.initializer, depth + 1);
        return std::nullopt;
    };
    return evaluate_integer(std::span(effect.tokens).subspan(range.begin, range.size()), names).value;
}

}  // namespace

std::optional<NumericType> numeric_type(const ParsedEffect& effect, const TypeName& type) {
    return numeric_type(effect, type, 0);
}

const Struct* find_struct(const ParsedEffect& effect, const TypeName& type) {
    std::string_view name = type.name;
    for (int depth = 0; depth < max_typedef_depth; ++depth) {
        for (const Struct& structure : effect.structs)
            if (structure.name == name) return &structure;
        const auto alias = std::find_if(effect.typedefs.begin(), effect.typedefs.end(),
                                        [&](const Typedef& candidate) { return candidate.name == name; });
        if (alias == effect.typedefs.end()) return nullptr;
        name = alias->type.name;
    }
    return nullptr;
}

bool is_sampler(const TypeName& type) {
    return type.name.starts_with("sampler");
}

std::string spelling(ScalarType scalar, unsigned components) {
    static constexpr const char* names[] = {"bool", "int", "uint", "float"};
    std::string text = names[static_cast<int>(scalar)];
    if (components > 1) text += std::to_string(components);
    return text;
}

std::string spelling(const NumericType& type) {
    if (!type.is_matrix) return spelling(type.scalar, type.columns);
    return spelling(type.scalar, 1) + std::to_string(type.rows) + 'x' + std::to_string(type.columns);
}

std::optional<std::int64_t> array_size(const ParsedEffect& effect, TokenRange dimension) {
    return constant_integer(effect, dimension, 0);
}

}  // namespace permgen

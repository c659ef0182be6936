#include <fmt/format.h>

#include <bit>
#include <limits>
#include <set>

#include "emit/emit.h"
#include "emit/namespace_name.h"

namespace permgen {
namespace {

std::string_view cpp_type(ScalarType type) {
    constexpr std::string_view names[] = {"bool", "std::int32_t", "std::uint32_t", "float"};
    return names[static_cast<int>(type)];
}

std::string cpp_float(float value) {
    std::string text = fmt::format("{}", value);  // the shortest text that parses as the same float
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text + "f";
}

std::string cpp_literal(ScalarType type, std::uint32_t bits) {
    switch (type) {
        case ScalarType::Bool:
            return bits != 0 ? "true" : "false";
        case ScalarType::Int: {
            const auto value = std::bit_cast<std::int32_t>(bits);
            // -2147483648 is a minus sign in front of a number that int cannot hold.
            if (value == std::numeric_limits<std::int32_t>::min()) return fmt::format("{} - 1", value + 1);
            return fmt::format("{}", value);
        }
        case ScalarType::Uint:
            return fmt::format("{}u", bits);
        case ScalarType::Float:
            return cpp_float(std::bit_cast<float>(bits));
    }
    return {};
}

/// The author's name as a C++ identifier: with a trailing underscore for a keyword, and more while the name is taken.
std::string cpp_name(const std::string& author, std::set<std::string>& taken) {
    std::string name = author;
    if (is_keyword(name)) name += '_';
    while (!taken.insert(name).second) name += '_';
    return name;
}

std::vector<std::string> technique_names(const Program& program) {
    std::set<std::string> taken;
    // Unchanged names take precedence: with `new` and `new_`, only `new` changes.
    for (const LoweredTechnique& technique : program.effect.techniques)
        if (!is_keyword(technique.name)) taken.insert(technique.name);
    std::vector<std::string> names;
    for (const LoweredTechnique& technique : program.effect.techniques)
        names.push_back(is_keyword(technique.name) ? cpp_name(technique.name, taken) : technique.name);
    return names;
}

std::vector<std::string> field_names(const LoweredModule& module, const std::string& key) {
    std::set<std::string> taken{key};
    std::vector<std::string> names;
    for (const LoweredAxis& axis : module.axes) names.push_back(cpp_name(axis.name, taken));
    return names;
}

void emit_key(const LoweredModule& module, std::string& out) {
    const std::string key = module.name + "_key";
    const auto fields = field_names(module, key);
    out += fmt::format("/// The axes of the entry point {}.\nstruct {} {{\n", module.author_entry, key);
    for (std::size_t i = 0; i < module.axes.size(); ++i)
        out += fmt::format("    {} {} = {};\n", cpp_type(module.axes[i].type), fields[i],
                           cpp_literal(module.axes[i].type, module.axes[i].default_bits));
    out += fmt::format("    friend constexpr bool operator==(const {0}&, const {0}&) = default;\n}};\n\n", key);
}

void emit_row(const LoweredShader& shader, int module, const std::string& technique, std::string& out) {
    if (shader.module != module) return;
    out += fmt::format("    {{TechniqueId::{}, {{", technique);
    for (std::size_t i = 0; i < shader.constants.size(); ++i)
        out += (i ? ", " : "") + cpp_literal(shader.constants[i].type, shader.constants[i].bits);
    out += "}},\n";
}

/// Indices and values only: under -fsanitize=undefined GCC does not compare addresses in constant expressions.
void emit_lookup(const Program& program, std::size_t index, const std::vector<std::string>& techniques,
                 std::string& out) {
    const LoweredModule& module = program.effect.modules[index];
    const std::string key = module.name + "_key";
    out += fmt::format(
        "namespace detail {{\nstruct {0}_row {{\n    TechniqueId technique;\n    {0} key;\n}};\n"
        "inline constexpr {0}_row {0}_rows[] = {{\n",
        key);
    for (std::size_t t = 0; t < techniques.size(); ++t)
        for (const LoweredPass& pass : program.effect.techniques[t].passes) {
            emit_row(pass.vertex, static_cast<int>(index), techniques[t], out);
            emit_row(pass.pixel, static_cast<int>(index), techniques[t], out);
            emit_row(pass.compute, static_cast<int>(index), techniques[t], out);
        }
    out += fmt::format(
        "}};\n}}  // namespace detail\n\n"
        "/// The first technique with a pass that is compiled with this key; nullopt if there is none.\n"
        "constexpr std::optional<TechniqueId> find_technique(const {0}& key) {{\n"
        "    for (const detail::{0}_row& row : detail::{0}_rows)\n"
        "        if (row.key == key) return row.technique;\n"
        "    return std::nullopt;\n}}\n\n"
        "/// The key in the technique's first pass that uses {1}; nullopt if no pass uses it.\n"
        "constexpr std::optional<{0}> {0}_of(TechniqueId id) {{\n"
        "    for (const detail::{0}_row& row : detail::{0}_rows)\n"
        "        if (row.technique == id) return row.key;\n"
        "    return std::nullopt;\n}}\n\n",
        key, module.author_entry);
}

}  // namespace

std::string emit_keys(const Program& program) {
    const auto techniques = technique_names(program);
    std::string out = "/// The techniques in the effect's order.\nenum class TechniqueId : std::uint16_t {\n";
    for (const std::string& name : techniques) out += fmt::format("    {},\n", name);
    out += fmt::format("}};\n\ninline constexpr std::size_t technique_count = {};\n\n", techniques.size());
    if (!techniques.empty())
        out +=
            "/// `id` must be one of the enumerators.\n"
            "constexpr const permgen::Technique& technique(TechniqueId id) {\n"
            "    return detail::techniques[static_cast<std::size_t>(id)];\n}\n\n";
    for (std::size_t m = 0; m < program.effect.modules.size(); ++m) {
        if (program.effect.modules[m].axes.empty()) continue;
        emit_key(program.effect.modules[m], out);
        emit_lookup(program, m, techniques, out);
    }
    return out;
}

}  // namespace permgen

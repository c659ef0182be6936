#include "lower/lower_wrapper.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <set>

#include "front/parse_cursor.h"
#include "front/report.h"

namespace permgen {
namespace {

constexpr const char* result_name = "permgen_result";
constexpr std::string_view component_names = "xyzw";

std::string argument_name(std::size_t index) {
    return "permgen_argument" + std::to_string(index);
}
std::string axis_name(std::string_view parameter) {
    return "permgen_axis_" + std::string(parameter);
}

// to_chars gives the shortest digits that parse as the same float.
std::string constant_declaration(const LoweredAxis& axis) {
    std::string value;
    switch (axis.type) {
        case ScalarType::Bool:
            value = axis.default_bits ? "true" : "false";
            break;
        case ScalarType::Int:
            value = std::to_string(static_cast<std::int32_t>(axis.default_bits));
            break;
        case ScalarType::Uint:
            value = std::to_string(axis.default_bits) + 'u';
            break;
        case ScalarType::Float: {
            std::array<char, 64> digits{};
            const float number = std::bit_cast<float>(axis.default_bits);
            const auto end =
                std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::scientific).ptr;
            value.assign(digits.data(), end);
            break;
        }
    }
    return "[[vk::constant_id(" + std::to_string(axis.id) + ")]] const " + spelling(axis.type, 1) + ' ' +
           axis_name(axis.name) + " = " + value + ';';
}

bool is_void(const TypeName& type) {
    return type.name == "void";
}

bool reads(const Variable& parameter) {
    return parameter.qualifiers.in || !parameter.qualifiers.out;
}

std::string swizzle(unsigned components) {
    return '.' + std::string(component_names.substr(0, components));
}

// "permgen_in.X" as a value of the author's type.
std::string converted_input(const InterfaceSlot& slot) {
    std::string value = "permgen_in." + slot.canonical();
    if (slot.conversion == Conversion::PixelIndex) value = "floor(" + value + ')';
    if (slot.conversion == Conversion::FaceSign)
        value = '(' + value + " ? 1.0 : -1.0)";
    else if (slot.author_components < slot.components)
        value += swizzle(slot.author_components);
    const bool cast = slot.conversion == Conversion::Cast || slot.author_scalar != slot.scalar;
    return cast ? '(' + spelling(slot.author_scalar, slot.author_components) + ")(" + value + ')' : value;
}

void copy_in(LoweredText& text, const InterfaceSlot& slot) {
    const std::string value = slot.absent ? "0" : converted_input(slot);
    if (!slot.is_matrix_column) return add_line(text, "    " + slot.path + " = " + value + ';');
    for (unsigned row = 0; row < slot.author_components; ++row) {
        const std::string component = slot.author_components > 1 ? std::string(".") + component_names[row] : "";
        add_line(text, "    " + slot.path + '[' + std::to_string(row) + "][" + std::to_string(slot.matrix_column) +
                           "] = (" + value + ')' + component + ';');
    }
}

void copy_out(LoweredText& text, const InterfaceSlot& slot) {
    std::string value = slot.path;
    if (slot.is_matrix_column) {
        value = spelling(slot.author_scalar, slot.author_components) + '(';
        for (unsigned row = 0; row < slot.author_components; ++row)
            value += (row == 0 ? "" : ", ") + slot.path + '[' + std::to_string(row) + "][" +
                     std::to_string(slot.matrix_column) + ']';
        value += ')';
    }
    if (slot.conversion == Conversion::None && slot.author_components < slot.components) {
        // Missing components are those of (0, 0, 0, 1), as in a vertex element that D3D9 expands.
        value = spelling(slot.scalar, slot.components) + '(' + value;
        for (unsigned c = slot.author_components; c < slot.components; ++c) value += c == 3 ? ", 1" : ", 0";
        value += ')';
    }
    if (slot.conversion == Conversion::Cast) value = '(' + spelling(slot.scalar, slot.components) + ")(" + value + ')';
    add_line(text, "    permgen_out." + slot.canonical() + " = " + value + ';');
}

void declare_structure(LoweredText& text, const std::string& name, Stage stage, Direction direction,
                       const LocationTable& locations, const std::vector<InterfaceSlot>& slots) {
    add_line(text, "struct " + name + " {");
    std::set<std::string> declared;
    for (const InterfaceSlot& slot : slots) {
        const std::string semantic = slot.canonical();
        if (slot.absent || !declared.insert(semantic).second) continue;  // VPOS and POSITION: one builtin, read twice
        std::string line = "    ";
        if (slot.point_size)
            line += "[[vk::builtin(\"PointSize\")]] ";
        else if (slot.system_value.empty())
            line += "[[vk::location(" + std::to_string(location(locations, stage, direction, slot)) + ")]] ";
        line += slot.interpolation + spelling(slot.scalar, slot.components) + ' ' + semantic;
        if (!slot.point_size && !slot.system_value.empty()) line += " : " + slot.system_value;
        // The location is already written; glslang recognizes a render target by its semantic.
        else if (stage == Stage::Pixel && direction == Direction::Out)
            line += " : SV_Target" + std::to_string(slot.semantic.index);
        add_line(text, line + ';');
    }
    add_line(text, "};");
}

std::string dimensions_text(const ParsedEffect& effect, const Variable& variable) {
    std::string text;
    for (const TokenRange dimension : variable.dimensions) text += '[' + hlsl_text(effect, dimension) + ']';
    return text;
}

std::string call(const EntryPoint& entry) {
    std::string text = hlsl_name(entry.bound.function->name) + '(';
    std::size_t uniform = 0;
    const std::vector<Variable>& parameters = entry.bound.function->parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (i > 0) text += ", ";
        if (!is_uniform_parameter(parameters[i])) {
            text += argument_name(i);
            continue;
        }
        const BoundParameter& bound = entry.bound.uniforms[uniform++];
        text += bound.is_axis ? axis_name(parameters[i].name) : bound.expression;
    }
    return text + ");";
}

std::vector<LoweredAttribute> attributes(Stage stage, Direction direction, const LocationTable& locations,
                                         const std::vector<InterfaceSlot>& slots) {
    std::vector<LoweredAttribute> result;
    for (const InterfaceSlot& slot : slots) {
        LoweredAttribute attribute;
        attribute.semantic = slot.canonical();
        const bool known = std::any_of(result.begin(), result.end(), [&](const LoweredAttribute& other) {
            return other.semantic == attribute.semantic;
        });
        if (known || slot.absent) continue;
        attribute.builtin = !slot.system_value.empty();
        if (!attribute.builtin) attribute.location = location(locations, stage, direction, slot);
        attribute.components = slot.components;
        attribute.type = slot.scalar;
        attribute.place = slot.place;
        result.push_back(std::move(attribute));
    }
    return result;
}

void refuse_outputs(const Sources& sources, const Function& function, Diagnostics& diagnostics) {
    const std::string remedy = "; write into a RW resource, such as a RWTexture2D, instead";
    if (!is_void(function.result))
        report_error(diagnostics, "PG035", sources.place(function.at),
                     "compute shader '" + std::string(function.name) + "' returns a value; make it void" + remedy);
    for (const Variable& parameter : function.parameters)
        if (parameter.qualifiers.out)
            report_error(diagnostics, "PG035", sources.place(parameter.at),
                         "'" + std::string(parameter.name) + "' cannot be a compute shader's output" + remedy);
}

/// Vulkan allows groupshared variables in compute modules only. The entry point cannot reach one (PG048), but the text
/// that all modules share has functions that do.
void make_groupshared_private(std::string& hlsl) {
    constexpr std::string_view word = "groupshared", other = "static";
    const auto in_a_name = [&](std::size_t at) {
        return at < hlsl.size() && (std::isalnum(static_cast<unsigned char>(hlsl[at])) != 0 || hlsl[at] == '_');
    };
    for (std::size_t at = hlsl.find(word); at != std::string::npos; at = hlsl.find(word, at + 1))
        if (!in_a_name(at + word.size()) && (at == 0 || !in_a_name(at - 1))) hlsl.replace(at, word.size(), other);
}

}  // namespace

void find_interface(const ParsedEffect& effect, const Sources& sources, EntryPoint& entry, Diagnostics& diagnostics) {
    const Function& function = *entry.bound.function;
    if (entry.stage == Stage::Compute) refuse_outputs(sources, function, diagnostics);
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const Variable& parameter = function.parameters[i];
        if (is_uniform_parameter(parameter)) continue;
        if (reads(parameter))
            flatten(effect, sources, parameter, argument_name(i), entry.stage, Direction::In, entry.inputs,
                    diagnostics);
        if (parameter.qualifiers.out && entry.stage != Stage::Compute)
            flatten(effect, sources, parameter, argument_name(i), entry.stage, Direction::Out, entry.outputs,
                    diagnostics);
    }
    if (!is_void(function.result) && entry.stage != Stage::Compute) {
        Variable result;
        result.type = function.result;
        result.name = function.name;
        result.at = function.at;
        result.semantic = function.semantic;
        flatten(effect, sources, result, result_name, entry.stage, Direction::Out, entry.outputs, diagnostics);
    }
    check_distinct(entry.inputs, function.name, diagnostics);
    check_distinct(entry.outputs, function.name, diagnostics);
    const auto is_position = [](const InterfaceSlot& slot) { return slot.system_value == "SV_Position"; };
    if (entry.stage == Stage::Vertex && std::none_of(entry.outputs.begin(), entry.outputs.end(), is_position))
        report_error(diagnostics, "PG040", sources.place(function.at),
                     "vertex shader '" + std::string(function.name) + "' has no output with the semantic POSITION");
}

LoweredModule make_module(const ParsedEffect& effect, const Sources& sources, const EntryPoint& entry,
                          const LocationTable& locations, LoweredText author) {
    const Function& function = *entry.bound.function;
    LoweredModule module;
    module.name = entry.name;
    module.entry = "permgen_" + entry.name;
    module.author_entry = function.name;
    module.stage = entry.stage;
    module.profile = entry.profile;
    module.place = sources.place(function.at);
    module.group_size = entry.group_size;
    module.inputs = attributes(entry.stage, Direction::In, locations, entry.inputs);
    module.outputs = attributes(entry.stage, Direction::Out, locations, entry.outputs);

    LoweredText& text = author;
    if (entry.stage != Stage::Compute) make_groupshared_private(text.hlsl);
    for (const BoundParameter& bound : entry.bound.uniforms) {
        if (!bound.is_axis) continue;
        LoweredAxis axis;
        axis.name = bound.parameter->name;
        axis.id = static_cast<std::uint32_t>(module.axes.size());
        axis.type = bound.type;
        axis.default_bits = 0;
        axis.place = sources.place(bound.parameter->at);
        std::string problem;
        const TokenRange initial = bound.parameter->initializer;
        if (!initial.empty())
            axis.default_bits =
                literal_bits(std::span(effect.tokens).subspan(initial.begin, initial.size()), axis.type, problem)
                    .value_or(0);
        add_line(text, constant_declaration(axis), axis.place);
        module.axes.push_back(std::move(axis));
    }
    const bool has_inputs = !module.inputs.empty();
    const bool has_outputs = !entry.outputs.empty();
    if (has_inputs) declare_structure(text, "permgen_Inputs", entry.stage, Direction::In, locations, entry.inputs);
    if (has_outputs) declare_structure(text, "permgen_Outputs", entry.stage, Direction::Out, locations, entry.outputs);

    if (entry.stage == Stage::Compute)
        add_line(text, "[numthreads(" + std::to_string(entry.group_size[0]) + ", " +
                           std::to_string(entry.group_size[1]) + ", " + std::to_string(entry.group_size[2]) + ")]");
    add_line(text, std::string(has_outputs ? "permgen_Outputs " : "void ") + module.entry + '(' +
                       (has_inputs ? "permgen_Inputs permgen_in" : "") + ") {");
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const Variable& parameter = function.parameters[i];
        if (is_uniform_parameter(parameter)) continue;
        add_line(text, "    " + hlsl_text(effect, parameter.type.range) + ' ' + argument_name(i) +
                           dimensions_text(effect, parameter) + ';');
    }
    for (const InterfaceSlot& slot : entry.inputs) copy_in(text, slot);
    const std::string result =
        is_void(function.result) ? "" : hlsl_text(effect, function.result.range) + ' ' + result_name + " = ";
    add_line(text, "    " + result + call(entry), module.place);
    if (has_outputs) {
        add_line(text, "    permgen_Outputs permgen_out;");
        for (const InterfaceSlot& slot : entry.outputs) copy_out(text, slot);
        add_line(text, "    return permgen_out;");
    }
    add_line(text, "}");
    module.hlsl = std::move(text.hlsl);
    module.line_map = std::move(text.line_map);
    return module;
}

}  // namespace permgen

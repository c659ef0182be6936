#include "lower/lower_interface.h"

#include <algorithm>
#include <array>

#include "front/report.h"

namespace permgen {
namespace {

constexpr int max_struct_depth = 16;
constexpr std::int64_t max_array_elements = 64;

struct Flattening {
    const ParsedEffect& effect;
    const Sources& sources;
    Stage stage;
    Direction direction;
    std::vector<InterfaceSlot>& slots;
    Diagnostics& diagnostics;

    void error(const char* code, Location at, std::string message) const {
        report_error(diagnostics, code, sources.place(at), std::move(message));
    }
};

std::string semantic_text(const Semantic& semantic) {
    return semantic.name + std::to_string(semantic.index);
}

const char* side(const Flattening& f) {
    static constexpr const char* names[3][2] = {{"a vertex shader's input", "a vertex shader's output"},
                                                {"a pixel shader's input", "a pixel shader's output"},
                                                {"a compute shader's input", "a compute shader's output"}};
    return names[static_cast<int>(f.stage)][f.direction == Direction::Out];
}

bool is(const InterfaceSlot& slot, std::string_view name, std::string_view system_value) {
    return (slot.semantic.name == name && slot.semantic.index == 0) || slot.semantic.name == system_value;
}

struct ComputeInput {
    std::string_view semantic;
    const char* system_value;
    unsigned components;
};
constexpr std::array<ComputeInput, 4> compute_inputs = {{{"SV_DISPATCHTHREADID", "SV_DispatchThreadID", 3},
                                                         {"SV_GROUPTHREADID", "SV_GroupThreadID", 3},
                                                         {"SV_GROUPID", "SV_GroupID", 3},
                                                         {"SV_GROUPINDEX", "SV_GroupIndex", 1}}};
constexpr const char* compute_input_names = "SV_DispatchThreadID, SV_GroupThreadID, SV_GroupID or SV_GroupIndex";

// Sets the slot's system value if its semantic is one. False: the semantic is not allowed on this side.
bool resolve_system_value(const Flattening& f, InterfaceSlot& slot) {
    const bool system = slot.semantic.name.starts_with("SV_");
    const std::string index = std::to_string(slot.semantic.index);
    const auto becomes = [&](const char* name, ScalarType scalar, unsigned components) {
        slot.system_value = name;
        slot.scalar = scalar;
        slot.components = components;
        if (slot.conversion == Conversion::Cast || scalar != slot.author_scalar) slot.conversion = Conversion::Cast;
        return true;
    };
    if (f.stage == Stage::Compute) {
        for (const ComputeInput& input : compute_inputs)
            if (f.direction == Direction::In && slot.semantic.name == input.semantic && slot.semantic.index == 0)
                return becomes(input.system_value, ScalarType::Uint, input.components);
        return false;
    }
    if (f.stage == Stage::Vertex && f.direction == Direction::In) {
        if (slot.semantic.name == "SV_VERTEXID") return becomes("SV_VertexID", ScalarType::Uint, 1);
        if (slot.semantic.name == "SV_INSTANCEID") return becomes("SV_InstanceID", ScalarType::Uint, 1);
        if (slot.semantic.name == "SV_POSITION") slot.semantic.name = "POSITION";
        return slot.semantic.name == "POSITION" || !system;
    }
    if (f.stage == Stage::Pixel && f.direction == Direction::Out) {
        if (is(slot, "DEPTH", "SV_DEPTH")) return becomes("SV_Depth", ScalarType::Float, 1);
        if (slot.semantic.name == "SV_TARGET") slot.semantic.name = "COLOR";
        return slot.semantic.name == "COLOR" && slot.semantic.index < 8;
    }
    if (slot.semantic.name == "SV_CLIPDISTANCE" || slot.semantic.name == "SV_CULLDISTANCE") {
        slot.system_value = (slot.semantic.name == "SV_CLIPDISTANCE" ? "SV_ClipDistance" : "SV_CullDistance") + index;
        return true;
    }
    if (is(slot, "POSITION", "SV_POSITION") || (f.stage == Stage::Vertex && slot.semantic.name == "POSITIONT"))
        return becomes("SV_Position", ScalarType::Float, 4);
    if (f.stage == Stage::Vertex) {
        slot.point_size = is(slot, "PSIZE", "SV_POINTSIZE");
        if (slot.point_size) becomes("PSIZE", ScalarType::Float, 1);
        return slot.point_size || !system;
    }
    if (slot.semantic.name == "VPOS") {
        becomes("SV_Position", ScalarType::Float, 4);
        slot.conversion = Conversion::PixelIndex;
        return true;
    }
    if (slot.semantic.name == "VFACE") {
        becomes("SV_IsFrontFace", ScalarType::Bool, 1);
        slot.conversion = Conversion::FaceSign;
        return true;
    }
    if (is(slot, "PSIZE", "SV_POINTSIZE")) return slot.absent = true;
    if (slot.semantic.name == "SV_ISFRONTFACE") return becomes("SV_IsFrontFace", ScalarType::Bool, 1);
    return !system;
}

void add_slot(const Flattening& f, const Variable& leaf, InterfaceSlot slot) {
    slot.author_scalar = slot.scalar;
    slot.author_components = slot.components;
    if (slot.scalar == ScalarType::Bool) {
        slot.scalar = ScalarType::Uint;
        slot.conversion = Conversion::Cast;
    }
    if (!resolve_system_value(f, slot)) {
        std::string message = "'" + semantic_text(slot.semantic) + "' cannot be " + side(f);
        if (f.stage == Stage::Compute) message.append("; a compute shader reads ").append(compute_input_names);
        return f.error("PG035", slot.semantic.at, message);
    }
    if (f.stage == Stage::Compute && slot.author_scalar != ScalarType::Uint && slot.author_scalar != ScalarType::Int)
        return f.error("PG037", leaf.at,
                       "'" + std::string(leaf.name) + "' must be a " + spelling(slot.scalar, slot.components) +
                           " to be " + semantic_text(slot.semantic) + " of " + side(f));
    const bool wrong_width =
        slot.system_value == "SV_Position" && f.direction == Direction::Out && slot.author_components != 4;
    if (wrong_width || (slot.components < slot.author_components && !slot.system_value.empty()))
        return f.error("PG037", leaf.at,
                       "'" + std::string(leaf.name) + "' must be a " + spelling(slot.scalar, slot.components) +
                           " to be " + semantic_text(slot.semantic) + " of " + side(f));
    const bool varying = slot.system_value.empty() && (f.stage == Stage::Vertex) == (f.direction == Direction::Out);
    if (varying) {
        if (leaf.qualifiers.nointerpolation || slot.scalar != ScalarType::Float)
            slot.interpolation = "nointerpolation ";
        else if (leaf.qualifiers.centroid || leaf.semantic.centroid)
            slot.interpolation = "centroid ";
        else if (leaf.qualifiers.noperspective)
            slot.interpolation = "noperspective ";
    }
    f.slots.push_back(std::move(slot));
}

void flatten_numeric(const Flattening& f, const Variable& leaf, const NumericType& type, const std::string& path) {
    if (!leaf.semantic.present())
        return f.error("PG034", leaf.at,
                       "'" + std::string(leaf.name) + "' is " + side(f) + " without a semantic; add one, such as ': " +
                           (f.stage == Stage::Compute ? "SV_DispatchThreadID" : "TEXCOORD0") + "'");
    std::int64_t elements = 1;
    if (!leaf.dimensions.empty()) {
        const auto size = leaf.dimensions.size() == 1 ? array_size(f.effect, leaf.dimensions[0]) : std::nullopt;
        if (!size || *size < 1 || *size > max_array_elements)
            return f.error(
                "PG037", leaf.at,
                "array '" + std::string(leaf.name) + "' as " + side(f) + " needs one constant size from 1 to 64");
        elements = *size;
    }
    InterfaceSlot slot;
    slot.semantic = leaf.semantic;
    slot.scalar = type.scalar;
    slot.place = f.sources.place(leaf.at);
    const unsigned first = leaf.semantic.index;
    unsigned next = first;
    for (std::int64_t element = 0; element < elements; ++element) {
        const std::string at = leaf.dimensions.empty() ? path : path + '[' + std::to_string(element) + ']';
        const unsigned registers = !type.is_matrix ? 1 : leaf.qualifiers.row_major ? type.rows : type.columns;
        for (unsigned k = 0; k < registers; ++k) {
            slot.semantic.index = next++;
            slot.path = type.is_matrix && leaf.qualifiers.row_major ? at + '[' + std::to_string(k) + ']' : at;
            slot.is_matrix_column = type.is_matrix && !leaf.qualifiers.row_major;
            slot.matrix_column = k;
            slot.components = slot.is_matrix_column ? type.rows : type.columns;
            add_slot(f, leaf, slot);
        }
    }
}

void flatten_at(const Flattening& f, const Variable& variable, const std::string& path, int depth) {
    if (const auto type = numeric_type(f.effect, variable.type)) return flatten_numeric(f, variable, *type, path);
    const Struct* structure = find_struct(f.effect, variable.type);
    const std::string type_name(variable.type.name);
    if (!structure)
        return f.error("PG037", variable.type.at,
                       "type '" + type_name + "' of '" + std::string(variable.name) + "' cannot be " + side(f));
    if (depth >= max_struct_depth)
        return f.error("PG037", variable.at, "struct '" + type_name + "' contains itself or is nested too deeply");
    if (!variable.dimensions.empty())
        return f.error("PG037", variable.at, "an array of structs cannot be " + std::string(side(f)));
    for (const Variable& member : structure->members)
        flatten_at(f, member, path + '.' + std::string(member.name), depth + 1);
}

struct FixedLocation {
    std::string_view semantic;
    unsigned count;
    std::uint32_t first;
};
constexpr std::array<FixedLocation, 8> vertex_inputs = {{{"POSITION", 1, 0},
                                                         {"NORMAL", 1, 1},
                                                         {"TEXCOORD", 8, 2},
                                                         {"COLOR", 2, 10},
                                                         {"TANGENT", 1, 12},
                                                         {"BINORMAL", 1, 13},
                                                         {"BLENDWEIGHT", 1, 14},
                                                         {"BLENDINDICES", 1, 15}}};
constexpr std::uint32_t first_free_vertex_input = 16;
constexpr std::array<FixedLocation, 2> varyings = {{{"COLOR", 2, 0}, {"TEXCOORD", 10, 2}}};
constexpr std::uint32_t first_free_varying = 12;

std::optional<std::uint32_t> fixed_location(std::span<const FixedLocation> table, const Semantic& semantic) {
    for (const FixedLocation& entry : table)
        if (entry.semantic == semantic.name && semantic.index < entry.count) return entry.first + semantic.index;
    return std::nullopt;
}

bool is_vertex_input(Stage stage, Direction direction) {
    return stage == Stage::Vertex && direction == Direction::In;
}
bool is_target(Stage stage, Direction direction) {
    return stage == Stage::Pixel && direction == Direction::Out;
}

}  // namespace

std::string InterfaceSlot::canonical() const {
    if (point_size || system_value.empty()) return semantic_text(semantic);
    std::string text = system_value;
    for (char& c : text)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return text;
}

void flatten(const ParsedEffect& effect, const Sources& sources, const Variable& variable, const std::string& path,
             Stage stage, Direction direction, std::vector<InterfaceSlot>& slots, Diagnostics& diagnostics) {
    flatten_at({effect, sources, stage, direction, slots, diagnostics}, variable, path, 0);
}

void check_distinct(const std::vector<InterfaceSlot>& slots, std::string_view entry, Diagnostics& diagnostics) {
    std::map<std::string, const InterfaceSlot*> seen;
    for (const InterfaceSlot& slot : slots) {
        const bool derived = slot.conversion == Conversion::PixelIndex || slot.conversion == Conversion::FaceSign;
        const auto [known, is_new] = seen.emplace((derived ? "derived " : "") + slot.canonical(), &slot);
        if (!is_new)
            report_error(diagnostics, "PG036", slot.place,
                         "semantic " + slot.canonical() + " is given twice among the values of '" + std::string(entry) +
                             "'; the first stands in line " + std::to_string(known->second->place.line));
    }
}

void widen(std::vector<InterfaceSlot>& outputs, const std::vector<InterfaceSlot>& inputs) {
    for (InterfaceSlot& output : outputs)
        for (const InterfaceSlot& input : inputs)
            if (output.system_value.empty() && !output.is_matrix_column && input.scalar == output.scalar &&
                output.conversion == Conversion::None && input.canonical() == output.canonical())
                output.components = std::max(output.components, input.components);
}

void collect(LocationTable& table, Stage stage, Direction direction, const std::vector<InterfaceSlot>& slots) {
    if (is_target(stage, direction)) return;
    const bool input = is_vertex_input(stage, direction);
    for (const InterfaceSlot& slot : slots) {
        if (!slot.system_value.empty() || slot.absent) continue;
        const bool fixed = input ? fixed_location(vertex_inputs, slot.semantic).has_value()
                                 : fixed_location(varyings, slot.semantic).has_value();
        if (!fixed) (input ? table.vertex_inputs : table.varyings)[{slot.semantic.name, slot.semantic.index}] = 0;
    }
}

void number(LocationTable& table) {
    std::uint32_t next = first_free_vertex_input;
    for (auto& [semantic, location] : table.vertex_inputs) location = next++;
    next = first_free_varying;
    for (auto& [semantic, location] : table.varyings) location = next++;
}

std::uint32_t location(const LocationTable& table, Stage stage, Direction direction, const InterfaceSlot& slot) {
    if (is_target(stage, direction)) return slot.semantic.index;
    const bool input = is_vertex_input(stage, direction);
    if (const auto fixed =
            input ? fixed_location(vertex_inputs, slot.semantic) : fixed_location(varyings, slot.semantic))
        return *fixed;
    return (input ? table.vertex_inputs : table.varyings).at({slot.semantic.name, slot.semantic.index});
}

}  // namespace permgen

#include <fmt/format.h>

#include <iterator>
#include <map>

#include "common/names.h"
#include "d3d9/image_formats.h"
#include "emit/emit.h"

namespace permgen {
namespace {

/// A C++ string literal. Bytes outside printable ASCII become octal escapes, which end after three digits.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            (out += '\\') += c;
        else if (byte < 0x20 || byte >= 0x7f)
            out += fmt::format("\\{:03o}", static_cast<unsigned>(byte));
        else
            out += c;
    }
    return out + '"';
}

std::string_view scalar_enum(ScalarType type) {
    constexpr std::string_view names[] = {"Bool", "Int", "Uint", "Float"};
    return names[static_cast<int>(type)];
}

std::string_view kind_enum(ResourceKind kind) {
    constexpr std::string_view names[] = {"UniformBuffer", "CombinedImageSampler", "StorageImage", "StorageBuffer"};
    return names[static_cast<int>(kind)];
}

std::string_view stage_enum(Stage stage) {
    constexpr std::string_view names[] = {"Vertex", "Pixel", "Compute"};
    return names[static_cast<int>(stage)];
}

std::string_view format_enum(ImageFormat format) {
    return format == ImageFormat::None ? "None" : d3d9::row_of(format).enumerator;
}

std::string_view kind_enum(ValueKind kind) {
    constexpr std::string_view names[] = {"Words", "Bool",   "Enum",   "Integer",   "Float",
                                          "Flags", "Colour", "Object", "Expression"};
    return names[static_cast<int>(kind)];
}

std::string_view dimension_enum(ImageDimension dimension) {
    constexpr std::string_view names[] = {"None", "One", "Two", "Three", "Cube"};
    return names[static_cast<int>(dimension)];
}

/// Writes the tables from the leaves up: an object must be declared before another points to it.
class HeaderWriter {
public:
    HeaderWriter(const Program& program, const EmitOptions& options) : program_(program), options_(options) {}
    std::string write();

private:
    template <typename... Arguments>
    void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(out_), format, std::forward<Arguments>(arguments)...);
        out_ += '\n';
    }
    /// Opens an array, or returns false: an array cannot be empty, and an empty span is written as {}.
    bool open(std::string_view type, const std::string& name, std::size_t count) {
        if (count > 0) line("inline constexpr {} {}[] = {{", type, name);
        return count > 0;
    }
    static std::string span_of(const std::string& name, std::size_t count) { return count > 0 ? name : "{}"; }

    void code(const std::string& name, const SpirvWords& words);
    void states(const std::string& name, const std::vector<LoweredState>& states);
    void module(std::size_t index);
    void resources();
    void members();
    void frozen(const SpirvWords& words);
    void shader_constants(const std::string& name, const LoweredShader& shader);
    std::string shader(const std::string& name, const LoweredShader& shader, const SpirvWords& frozen) const;
    void pass(std::size_t technique, std::size_t pass);
    void techniques();

    const Program& program_;
    const EmitOptions& options_;
    std::map<SpirvWords, std::string> frozen_;  ///< names of those already written; many passes share one
    std::string out_;
};

void HeaderWriter::code(const std::string& name, const SpirvWords& words) {
    if (!open("std::uint32_t", name, words.size())) return;
    constexpr std::size_t words_a_line = 9;  // 12 columns per word
    for (std::size_t i = 0; i < words.size(); ++i) {
        fmt::format_to(std::back_inserter(out_), "{}0x{:08x}u,", i % words_a_line ? " " : "    ", words[i]);
        if (i % words_a_line == words_a_line - 1 || i + 1 == words.size()) out_ += '\n';
    }
    line("}};");
}

void HeaderWriter::states(const std::string& name, const std::vector<LoweredState>& states) {
    if (!open("permgen::State", name, states.size())) return;
    for (const LoweredState& state : states)
        line("    {{{}, {}, permgen::StateId::{}, {}u, permgen::ValueKind::{}, 0x{:x}u}},", quoted(state.name),
             quoted(state.value), state_name(state.id), state.index, kind_enum(state.kind), state.bits);
    line("}};");
}

/// ", {8u, 8u, 1u}" of a compute module.
std::string group_size(const LoweredModule& module) {
    if (module.stage != Stage::Compute) return {};
    return fmt::format(", {{{}u, {}u, {}u}}", module.group_size[0], module.group_size[1], module.group_size[2]);
}

void HeaderWriter::module(std::size_t index) {
    const LoweredModule& module = program_.effect.modules[index];
    const std::string name = fmt::format("module_{}", index);
    code(name + "_code", program_.modules[index].code);
    if (open("permgen::Constant", name + "_axes", module.axes.size())) {
        for (const LoweredAxis& axis : module.axes)
            line("    {{{}, {}u, permgen::ScalarType::{}, 0x{:x}u}},", quoted(axis.name), axis.id,
                 scalar_enum(axis.type), axis.default_bits);
        line("}};");
    }
    const auto attributes = module_attributes(module);
    if (open("permgen::Attribute", name + "_attributes", attributes.size())) {
        for (const LoweredAttribute& attribute : attributes)
            line("    {{{}, {}u, {}u, permgen::ScalarType::{}}},", quoted(attribute.semantic), attribute.location,
                 attribute.components, scalar_enum(attribute.type));
        line("}};");
    }
    line("inline constexpr permgen::Module {} = {{{}, {}, permgen::Stage::{}, {}, {}, {}{}}};\n", name,
         quoted(module.name), quoted(program_.modules[index].reflection.entry), stage_enum(module.stage),
         name + "_code", span_of(name + "_axes", module.axes.size()), span_of(name + "_attributes", attributes.size()),
         group_size(module));
}

/// ", permgen::ImageFormat::R32f, true" of a storage image or buffer.
std::string storage_fields(const LoweredResource& resource) {
    if (resource.kind != ResourceKind::StorageImage && resource.kind != ResourceKind::StorageBuffer) return {};
    return fmt::format(", permgen::ImageFormat::{}, {}", format_enum(resource.format), resource.writable);
}

void HeaderWriter::resources() {
    const auto& all = program_.effect.resources;
    for (std::size_t i = 0; i < all.size(); ++i) states(fmt::format("resource_{}_states", i), all[i].sampler_states);
    if (!open("permgen::Resource", "resources", all.size())) return;
    for (std::size_t i = 0; i < all.size(); ++i)
        line("    {{{}, permgen::ResourceKind::{}, permgen::ImageDimension::{}, {}u, {}u, {}u, {}{}}},",
             quoted(all[i].name), kind_enum(all[i].kind), dimension_enum(all[i].dimension), all[i].set, all[i].binding,
             program_.resource_sizes[i], span_of(fmt::format("resource_{}_states", i), all[i].sampler_states.size()),
             storage_fields(all[i]));
    line("}};\n");
}

void HeaderWriter::members() {
    if (!open("permgen::Member", "members", program_.members.size())) return;
    for (const ReflectedMember& member : program_.members)
        line("    {{{}, {}, {}u, {}u}},", quoted(member.block), quoted(member.name), member.offset, member.size);
    line("}};\n");
}

void HeaderWriter::frozen(const SpirvWords& words) {
    if (!options_.freeze || words.empty()) return;
    const auto [entry, added] = frozen_.try_emplace(words, fmt::format("frozen_{}", frozen_.size()));
    if (added) code(entry->second, words);
}

void HeaderWriter::shader_constants(const std::string& name, const LoweredShader& shader) {
    if (!open("permgen::Constant", name + "_constants", shader.constants.size())) return;
    for (const LoweredConstant& constant : shader.constants)
        line("    {{{}, {}u, permgen::ScalarType::{}, 0x{:x}u}},", quoted(constant.name), constant.id,
             scalar_enum(constant.type), constant.bits);
    line("}};");
}

std::string HeaderWriter::shader(const std::string& name, const LoweredShader& shader, const SpirvWords& frozen) const {
    if (shader.module < 0) return "{nullptr, {}, {}}";
    return fmt::format("{{&module_{}, {}, {}}}", shader.module, span_of(name + "_constants", shader.constants.size()),
                       options_.freeze ? frozen_.at(frozen) : "{}");
}

void HeaderWriter::pass(std::size_t technique, std::size_t index) {
    const LoweredPass& pass = program_.effect.techniques[technique].passes[index];
    const BuiltPass& built = program_.passes[technique][index];
    const std::string name = fmt::format("pass_{}_{}", technique, index);
    shader_constants(name + "_vertex", pass.vertex);
    shader_constants(name + "_pixel", pass.pixel);
    shader_constants(name + "_compute", pass.compute);
    frozen(built.vertex.code);
    frozen(built.pixel.code);
    frozen(built.compute.code);
    if (open("const permgen::Resource*", name + "_live", built.live.size())) {
        for (const std::size_t live : built.live) line("    &resources[{}],", live);
        line("}};");
    }
    states(name + "_states", pass.states);
}

void HeaderWriter::techniques() {
    const auto& all = program_.effect.techniques;
    for (std::size_t t = 0; t < all.size(); ++t) {
        const auto& passes = all[t].passes;
        for (std::size_t p = 0; p < passes.size(); ++p) pass(t, p);
        if (!open("permgen::Pass", fmt::format("technique_{}_passes", t), passes.size())) continue;
        for (std::size_t p = 0; p < passes.size(); ++p) {
            const std::string name = fmt::format("pass_{}_{}", t, p);
            const BuiltPass& built = program_.passes[t][p];
            line("    {{{}, {}, {}, {}, {}{}}},", quoted(passes[p].name),
                 shader(name + "_vertex", passes[p].vertex, built.vertex.code),
                 shader(name + "_pixel", passes[p].pixel, built.pixel.code), span_of(name + "_live", built.live.size()),
                 span_of(name + "_states", passes[p].states.size()),
                 passes[p].compute.module < 0
                     ? ""
                     : ", " + shader(name + "_compute", passes[p].compute, built.compute.code));
        }
        line("}};\n");
    }
    if (!open("permgen::Technique", "techniques", all.size())) return;
    for (std::size_t t = 0; t < all.size(); ++t)
        line("    {{{}, {}}},", quoted(all[t].name),
             span_of(fmt::format("technique_{}_passes", t), all[t].passes.size()));
    line("}};\n");
}

std::string HeaderWriter::write() {
    line("// Generated by permgen from {}.fx; changes will be lost.", program_.effect.name);
    line(
        "#pragma once\n\n#include <cstddef>\n#include <cstdint>\n#include <optional>\n\n#include <permgen/tables.h>\n");
    line("namespace {} {{\nnamespace detail {{\n", options_.name_space);
    for (std::size_t i = 0; i < program_.modules.size(); ++i) module(i);
    if (open("const permgen::Module*", "modules", program_.modules.size())) {
        for (std::size_t i = 0; i < program_.modules.size(); ++i) line("    &module_{},", i);
        line("}};\n");
    }
    resources();
    members();
    techniques();
    const auto part = [](std::string_view name, std::size_t count) {
        return count > 0 ? fmt::format("detail::{}", name) : std::string("{}");
    };
    line("}}  // namespace detail\n");
    line("inline constexpr permgen::Effect effect = {{{}, {}, {}, {}, {}}};\n", quoted(program_.effect.name),
         part("modules", program_.modules.size()), part("resources", program_.effect.resources.size()),
         part("members", program_.members.size()), part("techniques", program_.effect.techniques.size()));
    out_ += emit_keys(program_);
    line("}}  // namespace {}", options_.name_space);
    return std::move(out_);
}

}  // namespace

std::string emit_header(const Program& program, const EmitOptions& options) {
    return HeaderWriter(program, options).write();
}

}  // namespace permgen

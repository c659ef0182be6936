#include "common/names.h"
#include "emit/emit.h"

namespace permgen {
namespace {

/// Replaces characters that some file system forbids; names in effects are identifiers, so this rarely changes one.
std::string file_safe(const std::string& name) {
    std::string safe;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                           c == '-' || static_cast<unsigned char>(c) >= 0x80;
        safe += plain ? c : '_';
    }
    return safe;
}

void add_frozen(const Program& program, std::size_t technique, std::size_t pass, std::vector<OutputFile>& files) {
    const BuiltPass& built = program.passes[technique][pass];
    if (!built.vertex.code.empty())
        files.push_back({frozen_file(program, technique, pass, Stage::Vertex), spirv_bytes(built.vertex.code)});
    if (!built.compute.code.empty())
        files.push_back({frozen_file(program, technique, pass, Stage::Compute), spirv_bytes(built.compute.code)});
    if (!built.pixel.code.empty())
        files.push_back({frozen_file(program, technique, pass, Stage::Pixel), spirv_bytes(built.pixel.code)});
}

}  // namespace

std::vector<LoweredAttribute> module_attributes(const LoweredModule& module) {
    std::vector<LoweredAttribute> attributes;
    if (module.stage == Stage::Compute) return attributes;
    for (const LoweredAttribute& attribute : module.stage == Stage::Vertex ? module.inputs : module.outputs)
        if (!attribute.builtin) attributes.push_back(attribute);
    return attributes;
}

std::string spirv_bytes(const SpirvWords& code) {
    std::string bytes;
    bytes.reserve(code.size() * 4);
    for (const std::uint32_t word : code)
        for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>((word >> shift) & 0xffu));
    return bytes;
}

std::string module_file(const Program& program, std::size_t module) {
    return file_safe(program.effect.name) + "." + file_safe(program.effect.modules[module].name) + ".spv";
}

std::string frozen_file(const Program& program, std::size_t technique, std::size_t pass, Stage stage) {
    // The number distinguishes passes with equal or empty names.
    const std::string& name = program.effect.techniques[technique].passes[pass].name;
    return file_safe(program.effect.name) + "." + file_safe(program.effect.techniques[technique].name) + "." +
           std::to_string(pass) + (name.empty() ? "" : "-" + file_safe(name)) + "." + std::string(stage_name(stage)) +
           ".spv";
}

std::vector<OutputFile> emit_files(const Program& program, const EmitOptions& options) {
    std::vector<OutputFile> files;
    for (std::size_t i = 0; i < program.modules.size(); ++i)
        files.push_back({module_file(program, i), spirv_bytes(program.modules[i].code)});
    for (std::size_t t = 0; options.freeze && t < program.passes.size(); ++t)
        for (std::size_t p = 0; p < program.passes[t].size(); ++p) add_frozen(program, t, p, files);
    files.push_back({program.effect.name + ".fx.json", emit_manifest(program, options)});
    files.push_back({program.effect.name + ".fx.h", emit_header(program, options)});
    return files;
}

std::string emit_depfile(const std::string& target, const std::vector<std::string>& dependencies) {
    const auto escape = [](const std::string& path) {
        std::string escaped;
        for (const char c : path) {
            if (c == ' ' || c == '#' || c == '%') escaped += '\\';
            if (c == '$') escaped += '$';
            escaped += c;
        }
        return escaped;
    };
    std::string text = escape(target) + ":";
    for (const std::string& dependency : dependencies) text += " \\\n  " + escape(dependency);
    return text + "\n";
}

}  // namespace permgen

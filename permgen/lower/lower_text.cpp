#include "lower/lower_text.h"

#include <algorithm>
#include <array>
#include <set>

#include "common/names.h"
#include "d3d9/storage_types.h"
#include "front/report.h"
#include "lower/check_storage.h"

namespace permgen {
namespace {

constexpr std::array<std::string_view, 27> renamed_words = {
    "point",       "line",          "triangle",    "lineadj",     "triangleadj",   "linear",         "texture",
    "sampler",     "precise",       "centroid",    "unorm",       "snorm",         "groupshared",    "globallycoherent",
    "Buffer",      "InputPatch",    "OutputPatch", "PointStream", "LineStream",    "TriangleStream", "Texture2D",
    "TextureCube", "noperspective", "Texture3D",   "Texture1D",   "sampler_state", "shared"};

constexpr int max_indentation = 80;
constexpr std::string_view globals_name = "Globals";

void end_line(LoweredText& text) {
    if (text.line.file < 0) return;
    text.hlsl += '\n';
    text.line = {};
}

std::string replacement(const Token& token, const Token& next) {
    if (!token.is_identifier()) return std::string(token.text);
    if (token.is("DWORD")) return "uint";
    if ((token.is("precise") || token.is("groupshared")) && next.is_identifier()) return std::string(token.text);
    return hlsl_name(token.text);
}

void add_token(LoweredText& text, const Sources& sources, const Token& token, std::string_view spelling) {
    if (text.line.file != token.at.file || text.line.line != token.at.line) {
        end_line(text);
        text.line = token.at;
        text.line_map.push_back(sources.place({token.at.file, token.at.line, 0}));
        text.hlsl.append(static_cast<std::size_t>(std::clamp(token.at.column - 1, 0, max_indentation)), ' ');
    } else if (text.behind.column != token.at.column || text.behind.line != token.at.line) {
        text.hlsl += ' ';
    }
    text.hlsl += spelling;
    text.behind = token.at;
    text.behind.column += static_cast<std::int32_t>(token.text.size());
}

class AuthorText {
public:
    AuthorText(const ParsedEffect& effect, const Sources& sources, const SamplerDimensions& dimensions,
               std::vector<LoweredResource>& resources, Diagnostics& diagnostics)
        : effect_(effect),
          sources_(sources),
          dimensions_(dimensions),
          resources_(resources),
          diagnostics_(diagnostics),
          dropped_(effect.dropped),
          written_(effect.items.size(), false) {}

    LoweredText run() {
        for (const Item& item : effect_.items)
            if (is_loose(item)) loose_.push_back(static_cast<std::size_t>(&item - effect_.items.data()));
        give_bindings();
        for (std::size_t i = 0; i < effect_.items.size(); ++i) {
            if (!loose_.empty() && i == loose_.front()) write_globals();
            write_item(i);
        }
        end_line(text_);
        return std::move(text_);
    }

private:
    // Globals that the application sets. `const` with an initializer means a constant to every author, although
    // D3D9 would let the application change it.
    bool is_loose(const Item& item) const {
        if (item.kind != ItemKind::Globals) return false;
        const Qualifiers& qualifiers = effect_.globals[item.index].qualifiers;
        if (qualifiers.is_static || qualifiers.groupshared) return false;
        return !is_constant(item);
    }

    bool is_constant(const Item& item) const {
        if (item.kind != ItemKind::Globals) return false;
        for (std::size_t g = item.index; g < item.index + item.count; ++g)
            if (!effect_.globals[g].qualifiers.is_const || effect_.globals[g].initializer.empty()) return false;
        return true;
    }

    void give_bindings() {
        std::uint32_t binding = 0;
        if (!loose_.empty()) {
            const Variable& first = effect_.globals[effect_.items[loose_.front()].index];
            add_resource(globals_name, ResourceKind::UniformBuffer, ImageDimension::None, binding, first.at);
        }
        ++binding;  // Reserved for the loose uniforms, even if there are none.
        for (std::size_t s = 0; s < effect_.samplers.size(); ++s) {
            const Sampler& sampler = effect_.samplers[s];
            add_resource(sampler.name, ResourceKind::CombinedImageSampler, dimensions_.samplers[s], binding++,
                         sampler.at);
        }
        for (const ConstantBuffer& buffer : effect_.constant_buffers)
            add_resource(buffer.name, ResourceKind::UniformBuffer, ImageDimension::None, binding++, buffer.at);
        for (const StorageResource& storage : effect_.storages) {
            const d3d9::StorageType& type = *d3d9::find_storage_type(storage.type);
            add_resource(storage.name, type.kind, type.dimension, binding++, storage.at);
            resources_.back().format = texel_format(effect_, storage);
            resources_.back().writable = type.writable;
        }
    }

    void add_resource(std::string_view name, ResourceKind kind, ImageDimension dimension, std::uint32_t binding,
                      Location at) {
        LoweredResource resource;
        resource.name = name;
        resource.kind = kind;
        resource.dimension = dimension;
        resource.binding = binding;
        resource.place = sources_.place(at);
        resources_.push_back(std::move(resource));
    }

    std::string attribute(std::string_view resource) const {
        for (const LoweredResource& candidate : resources_)
            if (candidate.name == resource)
                return "[[vk::binding(" + std::to_string(candidate.binding) + ", " + std::to_string(candidate.set) +
                       ")]] ";
        return {};
    }

    // glslang has its own words for DXC's attribute.
    static std::string format_attribute(const StorageResource& storage) {
        if (!storage.format) return {};
        const std::string_view name = storage.format->name;
        return "[[spv::format_" + std::string(name == "r11g11b10f" ? "r11fg11fb10f" : name) + "]] ";
    }

    void write_globals() {
        for (const std::size_t item : loose_) write_needed(item, loose_.front());
        add_line(text_, attribute(globals_name) + "cbuffer " + std::string(globals_name) + " {");
        for (const std::size_t i : loose_) {
            const Item& item = effect_.items[i];
            for (std::size_t g = item.index; g < item.index + item.count; ++g) drop_initializer(effect_.globals[g]);
            for (std::size_t t = item.range.begin; t < item.range.end; ++t)
                if (effect_.tokens[t].is("const")) dropped_[t] = true;
            write_tokens(item.range);
            written_[i] = true;
        }
        add_line(text_, "};");
    }

    // Structs, typedefs and constants that a gathered global needs are moved up with it.
    void write_needed(std::size_t user, std::size_t behind) {
        std::set<std::string_view> words;
        const TokenRange range = effect_.items[user].range;
        for (std::size_t t = range.begin; t < range.end; ++t)
            if (effect_.tokens[t].is_identifier()) words.insert(effect_.tokens[t].text);
        for (std::size_t i = behind; i < user; ++i) {
            if (written_[i] || !is_declared_by(effect_.items[i], words)) continue;
            written_[i] = true;  // Set first, so that a declaration that names itself ends the recursion.
            write_needed(i, behind);
            write_body(effect_.items[i]);
        }
    }

    bool is_declared_by(const Item& item, const std::set<std::string_view>& words) const {
        if (item.kind == ItemKind::Struct) return words.contains(effect_.structs[item.index].name);
        if (item.kind == ItemKind::Typedef) return words.contains(effect_.typedefs[item.index].name);
        if (item.kind != ItemKind::Globals || is_loose(item)) return false;
        for (std::size_t g = item.index; g < item.index + item.count; ++g)
            if (words.contains(effect_.globals[g].name)) return true;
        return false;
    }

    void drop_initializer(const Variable& variable) {
        if (variable.initializer.empty()) return;
        for (std::size_t t = variable.initializer.begin - 1; t < variable.initializer.end; ++t) dropped_[t] = true;
        report_warning(diagnostics_, "PG039", sources_.place(variable.at),
                       "the initial value of uniform '" + std::string(variable.name) +
                           "' is not applied; set it from the application, or declare it static const");
    }

    void write_item(std::size_t i) {
        if (written_[i]) return;
        written_[i] = true;
        write_body(effect_.items[i]);
    }

    void write_body(const Item& item) {
        if (item.kind == ItemKind::Sampler) {
            const Sampler& sampler = effect_.samplers[item.index];
            const ImageDimension dimension = dimensions_.samplers[item.index];
            add_line(text_, attribute(sampler.name) + sampler_type(dimension) + ' ' + hlsl_name(sampler.name) + ';',
                     sources_.place(sampler.at));
            return;
        }
        if (item.kind == ItemKind::Storage) {
            const StorageResource& storage = effect_.storages[item.index];
            const std::string element =
                storage.element.range.empty() ? "" : '<' + hlsl_text(effect_, storage.element.range) + '>';
            add_line(text_,
                     attribute(storage.name) + format_attribute(storage) + std::string(storage.type) + element + ' ' +
                         hlsl_name(storage.name) + ';',
                     sources_.place(storage.at));
            return;
        }
        if (item.kind == ItemKind::ConstantBuffer) {
            const ConstantBuffer& buffer = effect_.constant_buffers[item.index];
            for (const Variable& member : buffer.members) drop_initializer(member);
            add_line(text_, attribute(buffer.name), sources_.place(buffer.at));
        }
        if (is_constant(item) && !effect_.globals[item.index].qualifiers.is_static)
            add_line(text_, "static", sources_.place(effect_.globals[item.index].at));
        write_tokens(item.range);
        const bool unfinished = item.kind == ItemKind::ConstantBuffer && !effect_.tokens[item.range.end - 1].is(";");
        if (unfinished) add_line(text_, ";");
    }

    void write_tokens(TokenRange range) {
        for (std::size_t t = range.begin; t < range.end; ++t) {
            if (dropped_[t]) continue;
            const Token& token = effect_.tokens[t];
            const auto typed = dimensions_.parameter_types.find(t);
            const bool retyped = typed != dimensions_.parameter_types.end();
            add_token(text_, sources_, token, retyped ? typed->second : replacement(token, effect_.tokens[t + 1]));
        }
    }

    const ParsedEffect& effect_;
    const Sources& sources_;
    const SamplerDimensions& dimensions_;
    std::vector<LoweredResource>& resources_;
    Diagnostics& diagnostics_;
    std::vector<bool> dropped_;
    std::vector<bool> written_;
    std::vector<std::size_t> loose_;
    LoweredText text_;
};

}  // namespace

bool is_renamed(std::string_view word) {
    return std::find(renamed_words.begin(), renamed_words.end(), word) != renamed_words.end();
}

std::string hlsl_name(std::string_view name) {
    return (is_renamed(name) ? std::string(renamed_prefix) : std::string()) + std::string(name);
}

std::string hlsl_text(const ParsedEffect& effect, TokenRange range) {
    std::string text;
    for (std::size_t t = range.begin; t < range.end; ++t) {
        if (!text.empty()) text += ' ';
        text += replacement(effect.tokens[t], effect.tokens[t + 1]);
    }
    return text;
}

void add_line(LoweredText& text, std::string_view line, SourceLocation place) {
    end_line(text);
    text.hlsl += line;
    text.hlsl += '\n';
    text.line_map.push_back(std::move(place));
}

LoweredText author_text(const ParsedEffect& effect, const Sources& sources, const SamplerDimensions& dimensions,
                        std::vector<LoweredResource>& resources, Diagnostics& diagnostics) {
    return AuthorText(effect, sources, dimensions, resources, diagnostics).run();
}

}  // namespace permgen

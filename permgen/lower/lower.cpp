#include "lower/lower.h"

#include <algorithm>
#include <map>
#include <set>

#include "common/names.h"
#include "d3d9/profiles.h"
#include "front/report.h"
#include "lower/calls.h"
#include "lower/check_storage.h"
#include "lower/group_size.h"
#include "lower/lower_states.h"
#include "lower/lower_wrapper.h"
#include "lower/stage_functions.h"

namespace permgen {
namespace {

class Lowering {
public:
    Lowering(const ParsedEffect& effect, const Sources& sources, Diagnostics& diagnostics)
        : effect_(effect),
          sources_(sources),
          diagnostics_(diagnostics),
          states_(effect, sources, diagnostics),
          calls_(find_calls(effect)) {}

    Lowered run() {
        check_names();
        check_storage(effect_, sources_, calls_, diagnostics_);
        for (const ParsedTechnique& technique : effect_.techniques) lower_technique(technique);
        const SamplerDimensions dimensions = infer_sampler_dimensions(effect_, sources_, diagnostics_);
        const LoweredText author = author_text(effect_, sources_, dimensions, lowered_.resources, diagnostics_);
        lower_samplers();
        if (has_errors(diagnostics_)) return std::move(lowered_);
        widen_varyings();
        LocationTable locations;
        for (const EntryPoint& entry : entries_) {
            collect(locations, entry.stage, Direction::In, entry.inputs);
            collect(locations, entry.stage, Direction::Out, entry.outputs);
        }
        number(locations);
        for (const EntryPoint& entry : entries_)
            lowered_.modules.push_back(make_module(effect_, sources_, entry, locations, author));
        return std::move(lowered_);
    }

private:
    void error(const char* code, Location at, std::string message) {
        report_error(diagnostics_, code, sources_.place(at), std::move(message));
    }

    void widen_varyings() {
        for (EntryPoint& vertex : entries_)
            for (const EntryPoint& pixel : entries_)
                if (vertex.stage == Stage::Vertex && pixel.stage == Stage::Pixel) widen(vertex.outputs, pixel.inputs);
    }

    void check_names() {
        std::map<std::string_view, Location> declared;
        const auto declare = [&](std::string_view name, Location at) {
            const auto [known, is_new] = declared.emplace(name, at);
            if (!is_new)
                error("PG023", at,
                      "'" + std::string(name) + "' is declared twice; the first stands in line " +
                          std::to_string(known->second.line));
        };
        for (const Struct& structure : effect_.structs) declare(structure.name, structure.at);
        for (const Variable& global : effect_.globals) declare(global.name, global.at);
        for (const Sampler& sampler : effect_.samplers) declare(sampler.name, sampler.at);
        for (const StorageResource& storage : effect_.storages) declare(storage.name, storage.at);
        for (const TextureObject& texture : effect_.textures) declare(texture.name, texture.at);
        for (const ConstantBuffer& buffer : effect_.constant_buffers) {
            declare(buffer.name, buffer.at);
            for (const Variable& member : buffer.members) declare(member.name, member.at);
        }
        for (const Token& token : effect_.tokens) {
            if (!token.is_identifier() || !token.text.starts_with("permgen_")) continue;
            error("PG042", token.at, "'" + std::string(token.text) + "': names that begin with permgen_ are reserved");
            break;
        }
        const bool has_uniforms = std::any_of(
            effect_.globals.begin(), effect_.globals.end(),
            [](const Variable& global) { return !global.qualifiers.is_static && !global.qualifiers.groupshared; });
        if (const auto globals = declared.find("Globals"); has_uniforms && globals != declared.end())
            error("PG042", globals->second, "'Globals' is the name of the loose uniforms' block; use another name");
        if (effect_.techniques.empty() && !effect_.tokens.empty())
            error("PG027", Location{effect_.tokens.back().at.file, 0, 0},
                  "the effect has no technique; add technique NAME { pass NAME { ... } }");
    }

    void lower_samplers() {
        for (const Sampler& sampler : effect_.samplers)
            for (LoweredResource& resource : lowered_.resources)
                if (resource.name == sampler.name) resource.sampler_states = states_.sampler_states(sampler.states);
    }

    void lower_technique(const ParsedTechnique& technique) {
        LoweredTechnique result;
        result.name = technique.name;
        result.place = sources_.place(technique.at);
        for (const ParsedPass& pass : technique.passes) {
            LoweredPass lowered;
            lowered.name = pass.name;
            lowered.place = sources_.place(pass.at);
            lowered.states = states_.pass_states(pass.states);
            if (pass.vertex) lowered.vertex = lower_shader(*pass.vertex, Stage::Vertex);
            if (pass.pixel) lowered.pixel = lower_shader(*pass.pixel, Stage::Pixel);
            if (pass.compute) {
                lowered.compute = lower_shader(*pass.compute, Stage::Compute);
                for (const StateAssignment& state : pass.states) warn_unused(state);
            }
            result.passes.push_back(std::move(lowered));
        }
        lowered_.techniques.push_back(std::move(result));
    }

    void warn_unused(const StateAssignment& state) {
        report_warning(diagnostics_, "PG045", sources_.place(state.at),
                       "'" + state.name + "' has no effect in a pass that computes; remove it");
    }

    // The module of each entry point and stage. Compute profiles differ in the size of a group.
    static std::string stage_key(const Compile& compile, Stage stage) {
        const std::string key = std::string(compile.entry) + '|' + std::string(stage_name(stage));
        return stage == Stage::Compute ? key + std::string(d3d9::group_limits(compile.profile).profiles) : key;
    }

    LoweredShader lower_shader(const Compile& compile, Stage stage) {
        LoweredShader shader;
        shader.place = sources_.place(compile.at);
        std::optional<BoundEntry> bound = bind_arguments(effect_, sources_, compile, diagnostics_);
        if (!bound) return shader;
        // Literals become specialization constants of one shared module; other arguments become part of its text.
        std::string key = stage_key(compile, stage);
        for (const BoundParameter& parameter : bound->uniforms) {
            key += parameter.is_axis ? "|axis" : "|=" + parameter.expression;
            if (!parameter.is_axis) continue;
            shader.constants.push_back({std::string(parameter.parameter->name),
                                        static_cast<std::uint32_t>(shader.constants.size()), parameter.type,
                                        parameter.bits});
        }
        const auto [known, is_new] = modules_.emplace(key, static_cast<int>(entries_.size()));
        shader.module = known->second;
        if (!is_new) return shader;
        EntryPoint entry{unique_name(std::string(compile.entry)),
                         stage,
                         std::string(compile.profile),
                         std::move(*bound),
                         {},
                         {},
                         {}};
        if (stage == Stage::Compute)
            entry.group_size = group_size(effect_, sources_, *entry.bound.function, compile.profile, diagnostics_)
                                   .value_or(entry.group_size);
        check_stage_functions(effect_, sources_, calls_, *entry.bound.function, stage, diagnostics_);
        find_interface(effect_, sources_, entry, diagnostics_);
        entries_.push_back(std::move(entry));
        return shader;
    }

    // The function's own name for its first module, "name_2" and so on for the rest.
    std::string unique_name(const std::string& base) {
        std::string name = base;
        for (int n = 2; !names_.insert(name).second; ++n) name = base + '_' + std::to_string(n);
        return name;
    }

    const ParsedEffect& effect_;
    const Sources& sources_;
    Diagnostics& diagnostics_;
    StateChecker states_;
    std::vector<Call> calls_;
    Lowered lowered_;
    std::vector<EntryPoint> entries_;
    std::map<std::string, int> modules_;
    std::set<std::string> names_;
};

}  // namespace

Lowered lower(const ParsedEffect& effect, const Sources& sources, Diagnostics& diagnostics) {
    return Lowering(effect, sources, diagnostics).run();
}

}  // namespace permgen

#include <bit>
#include <nlohmann/json.hpp>

#include "common/names.h"
#include "emit/emit.h"
#include "emit/manifest_json.h"

namespace permgen {
namespace {

using Json = nlohmann::ordered_json;

Json states_json(const std::vector<LoweredState>& states) {
    Json list = Json::array();  // an array keeps the author's order
    for (const LoweredState& state : states)
        list.push_back({{"name", state.name},
                        {"value", state.value},
                        {"state", state_name(state.id)},
                        {"index", state.index},
                        {"kind", value_kind_name(state.kind)},
                        {"bits", state.bits}});
    return list;
}

Json module_json(const Program& program, std::size_t index) {
    const LoweredModule& module = program.effect.modules[index];
    Json axes = Json::array();
    for (const LoweredAxis& axis : module.axes)
        axes.push_back({{"name", axis.name},
                        {"id", axis.id},
                        {"type", scalar_name(axis.type)},
                        {"default", constant_json(axis.type, axis.default_bits)},
                        {"bits", axis.default_bits}});
    Json attributes = Json::array();
    for (const LoweredAttribute& attribute : module_attributes(module))
        attributes.push_back({{"semantic", attribute.semantic},
                              {"location", attribute.location},
                              {"components", attribute.components},
                              {"type", scalar_name(attribute.type)}});
    Json json = {{"name", module.name},
                 {"entry", program.modules[index].reflection.entry},
                 {"author_entry", module.author_entry},
                 {"profile", module.profile},
                 {"stage", stage_name(module.stage)},
                 {"file", module_file(program, index)},
                 {"axes", std::move(axes)},
                 {"attributes", std::move(attributes)}};
    if (module.stage == Stage::Compute) json["group_size"] = module.group_size;
    return json;
}

Json resource_json(const Program& program, std::size_t index) {
    const LoweredResource& resource = program.effect.resources[index];
    Json json = {{"name", resource.name},
                 {"kind", kind_name(resource.kind)},
                 {"set", resource.set},
                 {"binding", resource.binding}};
    if (resource.kind == ResourceKind::UniformBuffer || resource.kind == ResourceKind::StorageBuffer)
        json["size"] = program.resource_sizes[index];
    else
        json["dimension"] = dimension_name(resource.dimension);
    if (resource.kind == ResourceKind::CombinedImageSampler)
        json["sampler_states"] = states_json(resource.sampler_states);
    if (resource.kind == ResourceKind::StorageImage) json["format"] = format_name(resource.format);
    if (resource.kind == ResourceKind::StorageImage || resource.kind == ResourceKind::StorageBuffer)
        json["writable"] = resource.writable;
    return json;
}

Json shader_json(const Program& program, const LoweredShader& shader, const std::string& frozen) {
    if (shader.module < 0) return nullptr;
    Json constants = Json::array();
    for (const LoweredConstant& constant : shader.constants)
        constants.push_back({{"name", constant.name},
                             {"id", constant.id},
                             {"type", scalar_name(constant.type)},
                             {"value", constant_json(constant.type, constant.bits)},
                             {"bits", constant.bits}});
    Json json = {{"module", program.effect.modules[static_cast<std::size_t>(shader.module)].name},
                 {"constants", std::move(constants)}};
    if (!frozen.empty()) json["frozen"] = frozen;
    return json;
}

Json pass_json(const Program& program, const EmitOptions& options, std::size_t t, std::size_t p) {
    const LoweredPass& pass = program.effect.techniques[t].passes[p];
    Json live = Json::array();
    for (const std::size_t index : program.passes[t][p].live) live.push_back(program.effect.resources[index].name);
    const auto frozen = [&](Stage stage) { return options.freeze ? frozen_file(program, t, p, stage) : std::string(); };
    return {{"name", pass.name},
            {"vertex", shader_json(program, pass.vertex, frozen(Stage::Vertex))},
            {"pixel", shader_json(program, pass.pixel, frozen(Stage::Pixel))},
            {"compute", shader_json(program, pass.compute, frozen(Stage::Compute))},
            {"live", std::move(live)},
            {"states", states_json(pass.states)}};
}

}  // namespace

nlohmann::ordered_json constant_json(ScalarType type, std::uint32_t bits) {
    switch (type) {
        case ScalarType::Bool:
            return bits != 0;
        case ScalarType::Int:
            return std::bit_cast<std::int32_t>(bits);
        case ScalarType::Uint:
            return bits;
        case ScalarType::Float:
            return std::bit_cast<float>(bits);
    }
    return nullptr;
}

std::string emit_manifest(const Program& program, const EmitOptions& options) {
    Json modules = Json::array();
    for (std::size_t i = 0; i < program.modules.size(); ++i) modules.push_back(module_json(program, i));
    Json resources = Json::array();
    for (std::size_t i = 0; i < program.effect.resources.size(); ++i) resources.push_back(resource_json(program, i));
    Json members = Json::array();
    for (const ReflectedMember& member : program.members)
        members.push_back(
            {{"block", member.block}, {"name", member.name}, {"offset", member.offset}, {"size", member.size}});
    Json techniques = Json::array();
    for (std::size_t t = 0; t < program.passes.size(); ++t) {
        Json passes = Json::array();
        for (std::size_t p = 0; p < program.passes[t].size(); ++p) passes.push_back(pass_json(program, options, t, p));
        techniques.push_back({{"name", program.effect.techniques[t].name}, {"passes", std::move(passes)}});
    }
    const Json manifest = {{"format", 2},
                           {"effect", program.effect.name},
                           {"modules", std::move(modules)},
                           {"resources", std::move(resources)},
                           {"members", std::move(members)},
                           {"techniques", std::move(techniques)}};
    return manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace permgen

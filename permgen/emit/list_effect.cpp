#include "emit/list_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "emit/manifest_json.h"

namespace permgen {
namespace {

using Json = nlohmann::ordered_json;

Json shader_json(const Program& program, const LoweredShader& shader) {
    if (shader.module < 0) return nullptr;
    const LoweredModule& module = program.effect.modules[static_cast<std::size_t>(shader.module)];
    Json constants = Json::object();
    for (const LoweredConstant& constant : shader.constants)
        constants[constant.name] = constant_json(constant.type, constant.bits);
    Json json = {{"entry", module.author_entry}, {"module", module.name}, {"constants", std::move(constants)}};
    if (module.stage == Stage::Compute) json["group_size"] = module.group_size;
    return json;
}

Json pass_json(const Program& program, std::size_t t, std::size_t p) {
    const LoweredPass& pass = program.effect.techniques[t].passes[p];
    Json live = Json::array();
    for (const std::size_t index : program.passes[t][p].live) live.push_back(program.effect.resources[index].name);
    Json states = Json::object();
    for (const LoweredState& state : pass.states) states[state.name] = state.value;
    Json json = {{"name", pass.name},
                 {"vertex", shader_json(program, pass.vertex)},
                 {"pixel", shader_json(program, pass.pixel)},
                 {"live", std::move(live)},
                 {"states", std::move(states)}};
    if (pass.compute.module >= 0) json["compute"] = shader_json(program, pass.compute);
    return json;
}

/// "ps_main(false, true, true)"; "cs_main(true) [8, 8, 1]" with the thread group
std::string call_text(const Program& program, const LoweredShader& shader) {
    if (shader.module < 0) return "-";
    const LoweredModule& module = program.effect.modules[static_cast<std::size_t>(shader.module)];
    std::string text = module.author_entry + "(";
    for (std::size_t i = 0; i < shader.constants.size(); ++i)
        text += (i ? ", " : "") + constant_json(shader.constants[i].type, shader.constants[i].bits).dump();
    text += ")";
    if (module.stage != Stage::Compute) return text;
    return fmt::format("{} [{}, {}, {}]", text, module.group_size[0], module.group_size[1], module.group_size[2]);
}

}  // namespace

std::string list_json(const Program& program) {
    Json techniques = Json::array();
    for (std::size_t t = 0; t < program.passes.size(); ++t) {
        Json passes = Json::array();
        for (std::size_t p = 0; p < program.passes[t].size(); ++p) passes.push_back(pass_json(program, t, p));
        techniques.push_back({{"name", program.effect.techniques[t].name}, {"passes", std::move(passes)}});
    }
    const Json list = {{"effect", program.effect.name}, {"techniques", std::move(techniques)}};
    return list.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string list_table(const Program& program) {
    constexpr std::size_t columns = 6, compute_column = 4;
    using Row = std::array<std::string, columns>;
    std::vector<Row> rows{{"technique", "pass", "vertex", "pixel", "compute", "live"}};
    bool computes = false;
    for (std::size_t t = 0; t < program.passes.size(); ++t)
        for (std::size_t p = 0; p < program.passes[t].size(); ++p) {
            const LoweredTechnique& technique = program.effect.techniques[t];
            std::string live;
            for (const std::size_t index : program.passes[t][p].live)
                live += (live.empty() ? "" : ", ") + program.effect.resources[index].name;
            rows.push_back({technique.name, technique.passes[p].name, call_text(program, technique.passes[p].vertex),
                            call_text(program, technique.passes[p].pixel),
                            call_text(program, technique.passes[p].compute), live});
            computes |= technique.passes[p].compute.module >= 0;
        }
    std::array<std::size_t, columns> widths{};
    for (const Row& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    const auto counted = [](std::size_t count, const char* what) {
        return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
    };
    std::string text =
        fmt::format("{}: {} over {}\n", program.effect.name, counted(program.effect.techniques.size(), "technique"),
                    counted(program.effect.modules.size(), "module"));
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i)
            if (computes || i != compute_column) line += fmt::format("{:<{}}  ", row[i], widths[i]);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

}  // namespace permgen

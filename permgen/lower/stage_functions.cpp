#include "lower/stage_functions.h"

#include <algorithm>
#include <array>

#include "common/names.h"
#include "front/parse_cursor.h"
#include "front/report.h"
#include "lower/check_storage.h"

namespace permgen {
namespace {

// Their value depends on the pixels beside, or they drop a pixel.
constexpr std::array<std::string_view, 8> pixel_functions = {"ddx",        "ddy",      "ddx_coarse", "ddx_fine",
                                                             "ddy_coarse", "ddy_fine", "fwidth",     "clip"};
constexpr std::array<std::string_view, 4> texture_functions = {"tex1D", "tex2D", "tex3D", "texCUBE"};
constexpr std::size_t arguments_with_gradients = 4;  // tex2D(s, t, ddx, ddy)

constexpr std::array<std::string_view, 6> barriers = {"GroupMemoryBarrier",  "GroupMemoryBarrierWithGroupSync",
                                                      "DeviceMemoryBarrier", "DeviceMemoryBarrierWithGroupSync",
                                                      "AllMemoryBarrier",    "AllMemoryBarrierWithGroupSync"};

template <std::size_t N>
bool among(const std::array<std::string_view, N>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// The function that chooses the mip level from derivatives, as "tex2D"; empty for another function.
std::string_view implicit_level(std::string_view name, std::size_t arguments) {
    for (const std::string_view function : texture_functions) {
        if (!name.starts_with(function)) continue;
        const std::string_view rest = name.substr(function.size());
        if ((rest.empty() && arguments < arguments_with_gradients) || rest == "bias" || rest == "proj") return function;
    }
    return {};
}

class StageChecker {
public:
    StageChecker(const ParsedEffect& effect, const Sources& sources, Stage stage, Diagnostics& diagnostics)
        : effect_(effect), sources_(sources), stage_(stage), diagnostics_(diagnostics) {}

    void call(const Call& call) const {
        const Token& name = effect_.tokens[call.name_token];
        const bool authors = std::any_of(effect_.functions.begin(), effect_.functions.end(),
                                         [&](const Function& function) { return function.name == name.text; });
        if (authors || effect_.tokens[call.name_token - 1].is(".")) return;
        if (stage_ != Stage::Compute) {
            if (among(barriers, name.text)) only_compute(name.at, quoted(name));
            return;
        }
        if (among(pixel_functions, name.text)) only_pixel(name.at, quoted(name));
        if (const std::string_view function = implicit_level(name.text, call.arguments.size()); !function.empty())
            error(name.at, quoted(name) +
                               " chooses the mip level from the pixels beside, and a compute shader has none; "
                               "write " +
                               std::string(function) + "lod or " + std::string(function) + "grad");
    }

    void body(const Function& function) const {
        for (std::size_t i = function.body.begin; i < function.body.end; ++i) {
            const Token& word = effect_.tokens[i];
            if (stage_ == Stage::Compute) {
                if (word.is("discard")) only_pixel(word.at, "'discard'");
                continue;
            }
            if (!word.is_identifier()) continue;
            const StorageResource* storage = find_storage(effect_, word.text);
            const bool writes = storage && is_writable(*storage);
            const bool shared = std::any_of(
                effect_.globals.begin(), effect_.globals.end(),
                [&](const Variable& global) { return global.qualifiers.groupshared && global.name == word.text; });
            if ((writes || shared) && names_global(effect_, function, i))
                only_compute(word.at,
                             (writes ? std::string(storage->type) : "groupshared variable") + ' ' + quoted(word));
        }
    }

private:
    void error(Location at, std::string message) const {
        const SourceLocation place = sources_.place(at);
        const bool known = std::any_of(diagnostics_.begin(), diagnostics_.end(), [&](const Diagnostic& said) {
            return said.code == "PG048" && said.place.file == place.file && said.place.line == place.line &&
                   said.place.column == place.column;
        });
        if (!known) report_error(diagnostics_, "PG048", place, std::move(message));
    }
    void only_pixel(Location at, const std::string& what) const {
        error(at, what + " is for pixel shaders; a compute shader cannot use it: remove it, or pass a value instead");
    }
    void only_compute(Location at, const std::string& what) const {
        error(at, what + " is for compute shaders; a " + std::string(stage_name(stage_)) +
                      " shader cannot use it: compile the entry point as a ComputeShader");
    }

    const ParsedEffect& effect_;
    const Sources& sources_;
    Stage stage_;
    Diagnostics& diagnostics_;
};

}  // namespace

void check_stage_functions(const ParsedEffect& effect, const Sources& sources, const std::vector<Call>& calls,
                           const Function& entry, Stage stage, Diagnostics& diagnostics) {
    const StageChecker checker(effect, sources, stage, diagnostics);
    const std::vector<bool> reached = reachable_functions(effect, calls, entry);
    for (const Call& call : calls)
        if (reached[call.caller]) checker.call(call);
    for (std::size_t f = 0; f < effect.functions.size(); ++f)
        if (reached[f]) checker.body(effect.functions[f]);
}

}  // namespace permgen

#include "lower/lower_samplers.h"

#include <algorithm>
#include <array>

#include "front/parse_technique.h"
#include "front/report.h"
#include "lower/calls.h"

namespace permgen {
namespace {

struct Dimension {
    std::string_view type;
    std::string_view function;
    ImageDimension dimension;
};
constexpr std::array<Dimension, 4> dimension_table = {{{"sampler1D", "tex1D", ImageDimension::One},
                                                       {"sampler2D", "tex2D", ImageDimension::Two},
                                                       {"sampler3D", "tex3D", ImageDimension::Three},
                                                       {"samplerCUBE", "texCUBE", ImageDimension::Cube}}};

ImageDimension of_type(std::string_view type) {
    for (const Dimension& entry : dimension_table)
        if (same_word(entry.type, type)) return entry.dimension;
    return ImageDimension::None;
}

ImageDimension of_texture_function(std::string_view name) {
    for (const Dimension& entry : dimension_table) {
        if (!name.starts_with(entry.function)) continue;
        const std::string_view rest = name.substr(entry.function.size());
        if (rest.empty() || rest == "lod" || rest == "bias" || rest == "grad" || rest == "proj") return entry.dimension;
    }
    return ImageDimension::None;
}

class Inference {
public:
    Inference(const ParsedEffect& effect, const Sources& sources, Diagnostics& diagnostics)
        : effect_(effect), sources_(sources), diagnostics_(diagnostics), calls_(find_calls(effect)) {
        for (const Sampler& sampler : effect.samplers)
            result_.samplers.push_back(of_type(effect.tokens[sampler.type_token].text));
        for (const Function& function : effect.functions) {
            parameters_.emplace_back();
            for (const Variable& parameter : function.parameters)
                parameters_.back().push_back(of_type(parameter.type.name));
        }
    }

    SamplerDimensions run() {
        // Each round carries dimensions up by one call, and stops after a round without a change.
        while (!failed_ && propagate()) {
        }
        for (ImageDimension& dimension : result_.samplers)
            if (dimension == ImageDimension::None) dimension = ImageDimension::Two;
        for (std::size_t f = 0; f < effect_.functions.size(); ++f) {
            for (std::size_t p = 0; p < parameters_[f].size(); ++p) {
                const TypeName& type = effect_.functions[f].parameters[p].type;
                if (type.name != "sampler") continue;
                const ImageDimension dimension = parameters_[f][p];
                result_.parameter_types[type.range.begin] =
                    sampler_type(dimension == ImageDimension::None ? ImageDimension::Two : dimension);
            }
        }
        return std::move(result_);
    }

private:
    bool propagate() {
        bool changed = false;
        for (const Call& call : calls_) {
            const std::string_view name = effect_.tokens[call.name_token].text;
            const ImageDimension read = of_texture_function(name);
            if (read != ImageDimension::None && !call.arguments.empty()) changed |= learn(call, 0, read);
            for (std::size_t f = 0; f < effect_.functions.size(); ++f) {
                if (effect_.functions[f].name != name || parameters_[f].size() != call.arguments.size()) continue;
                for (std::size_t p = 0; p < parameters_[f].size(); ++p)
                    if (parameters_[f][p] != ImageDimension::None) changed |= learn(call, p, parameters_[f][p]);
            }
        }
        return changed;
    }

    // The call's argument is a sampler of `dimension`.
    bool learn(const Call& call, std::size_t argument, ImageDimension dimension) {
        const TokenRange range = call.arguments[argument];
        if (range.size() != 1 || !effect_.tokens[range.begin].is_identifier()) return false;
        const std::size_t token = range.begin;
        const std::string_view name = effect_.tokens[token].text;
        ImageDimension* known = nullptr;
        const std::vector<Variable>& parameters = effect_.functions[call.caller].parameters;
        for (std::size_t p = 0; p < parameters.size(); ++p)
            if (parameters[p].name == name) known = &parameters_[call.caller][p];
        for (std::size_t s = 0; !known && s < effect_.samplers.size(); ++s)
            if (effect_.samplers[s].name == name) known = &result_.samplers[s];
        if (!known || *known == dimension) return false;
        if (*known != ImageDimension::None) {
            report_error(diagnostics_, "PG038", sources_.place(effect_.tokens[token].at),
                         "'" + std::string(name) + "' is a " + sampler_type(*known) + " and cannot be read as a " +
                             sampler_type(dimension) + "; declare one sampler for each");
            failed_ = true;
            return false;
        }
        *known = dimension;
        return true;
    }

    const ParsedEffect& effect_;
    const Sources& sources_;
    Diagnostics& diagnostics_;
    std::vector<Call> calls_;
    std::vector<std::vector<ImageDimension>> parameters_;
    SamplerDimensions result_;
    bool failed_ = false;
};

}  // namespace

SamplerDimensions infer_sampler_dimensions(const ParsedEffect& effect, const Sources& sources,
                                           Diagnostics& diagnostics) {
    return Inference(effect, sources, diagnostics).run();
}

std::string sampler_type(ImageDimension dimension) {
    for (const Dimension& entry : dimension_table)
        if (entry.dimension == dimension) return std::string(entry.type);
    return "sampler2D";
}

}  // namespace permgen

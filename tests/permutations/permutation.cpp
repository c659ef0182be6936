#include "permutation.h"

#include <slices.fx.h>
#include <tyndall/plan.h>

#include <algorithm>
#include <array>
#include <bit>
#include <ostream>

#include "effects.h"

namespace tyndall::test {
namespace {

bool switchOf(const permgen::Technique& technique, std::string_view axis) {
    for (const permgen::Constant& constant : technique.passes[0].pixel.constants)
        if (constant.name == axis) return constant.bits != 0;
    return false;
}

bool isTerm(const permgen::Constant& constant) {
    return std::ranges::find(kSwitches.values, constant.name) != kSwitches.values.end();
}

/// Constants are in the order of the module's axes.
bool leavesFurtherSwitchesAlone(const permgen::Technique& technique) {
    for (const permgen::Shader* shader : {&technique.passes[0].vertex, &technique.passes[0].pixel})
        for (std::size_t i = 0; i < shader->constants.size(); ++i)
            if (!isTerm(shader->constants[i]) && shader->constants[i].bits != shader->module->axes[i].bits)
                return false;
    return technique.passes.size() == 1;
}

Permutation permutationOf(const permgen::Technique& technique) {
    if (const auto terms = termsOf(technique.name)) return {&technique, *terms, true, true};
    TermSet terms;
    for (const Term term : allTerms) terms = terms.with(term, switchOf(technique, kSwitches[term]));
    return {&technique, terms, false, leavesFurtherSwitchesAlone(technique)};
}

std::string valueOf(const permgen::Constant& constant) {
    switch (constant.type) {
        case permgen::ScalarType::Bool:
            return constant.bits != 0 ? "true" : "false";
        case permgen::ScalarType::Int:
            return std::to_string(std::bit_cast<std::int32_t>(constant.bits));
        case permgen::ScalarType::Uint:
            return std::to_string(constant.bits);
        case permgen::ScalarType::Float:
            return std::to_string(std::bit_cast<float>(constant.bits));
    }
    return {};
}

}  // namespace

const permgen::Effect& effectTables() {
    const permgen::Effect* given = effectUnderTest("slices");
    return given ? *given : slices::effect;
}

std::vector<std::pair<std::string, std::string>> Permutation::constants() const {
    std::vector<std::pair<std::string, std::string>> named;
    for (const permgen::Shader* shader : {&pass().vertex, &pass().pixel})
        for (const permgen::Constant& constant : shader->constants)
            named.emplace_back(constant.name, valueOf(constant));
    return named;
}

std::vector<Permutation> permutations() {
    std::vector<Permutation> all;
    for (const permgen::Technique& technique : effectTables().techniques) all.push_back(permutationOf(technique));
    return all;
}

std::vector<Permutation> predictedPermutations() {
    std::vector<Permutation> predicted = permutations();
    std::erase_if(predicted, [](const Permutation& permutation) { return !permutation.predicted; });
    return predicted;
}

Shot shotFor(const Permutation& permutation, const Shot& shot) {
    return withTerms(shot, permutation.terms);
}

DrawOptions optionsFor(const Permutation& permutation, DrawOptions options) {
    if (!permutation.chosen) options.drawnWith = permutation.technique->name;
    return options;
}

void PrintTo(const Permutation& permutation, std::ostream* out) {
    *out << permutation.technique->name;
}

}  // namespace tyndall::test

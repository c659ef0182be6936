#include "permutation.h"

#include <slices.fx.h>
#include <tyndall/plan.h>

#include <bit>
#include <ostream>
#include <stdexcept>

#include "effects.h"

namespace tyndall::test {
namespace {

bool switchOf(const permgen::Technique& technique, std::string_view axis) {
    for (const permgen::Constant& constant : technique.passes[0].pixel.constants)
        if (constant.name == axis) return constant.bits != 0;
    return false;
}

Permutation permutationOf(const permgen::Technique& technique) {
    for (int bits = 0; bits < 8; ++bits) {
        const bool noise = (bits & 4) != 0, shadow = (bits & 2) != 0, cookie = (bits & 1) != 0;
        if (technique.name == techniqueName(noise, shadow, cookie)) return {&technique, noise, shadow, cookie};
    }
    return {&technique, switchOf(technique, "bScrollingNoise"), switchOf(technique, "bShadowMapping"),
            switchOf(technique, "bCookie")};
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

Permutation permutation(bool noise, bool shadow, bool cookie) {
    for (const Permutation& candidate : permutations())
        if (candidate.noise == noise && candidate.shadow == shadow && candidate.cookie == cookie) return candidate;
    throw std::runtime_error("slices.fx has no technique with these terms");
}

Shot shotFor(const Permutation& permutation, const Shot& shot) {
    return withTerms(shot, permutation.noise, permutation.shadow, permutation.cookie);
}

void PrintTo(const Permutation& permutation, std::ostream* out) {
    *out << permutation.technique->name;
}

}  // namespace tyndall::test

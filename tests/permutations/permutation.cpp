#include "permutation.h"

#include <slices.fx.h>

#include <ostream>
#include <stdexcept>

namespace tyndall::test {
namespace {

bool switchOf(const permgen::Technique& technique, std::string_view axis) {
    for (const permgen::Constant& constant : technique.passes[0].pixel.constants)
        if (constant.name == axis) return constant.bits != 0;
    throw std::runtime_error("technique " + std::string(technique.name) + " does not set " + std::string(axis));
}

}  // namespace

std::vector<Permutation> permutations() {
    std::vector<Permutation> all;
    for (const permgen::Technique& technique : slices::effect.techniques)
        all.push_back({&technique, switchOf(technique, "bScrollingNoise"), switchOf(technique, "bShadowMapping"),
                       switchOf(technique, "bCookie")});
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

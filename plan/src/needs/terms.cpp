#include <slices.fx.h>
#include <tyndall/light.h>
#include <tyndall/terms.h>

#include <algorithm>

#include "needs/scattering.h"

namespace tyndall {
namespace {

namespace slices = effects::slices;

/// A term's name, and its switch in ps_main.
struct TermRow {
    std::string_view name;
    bool slices::ps_main_key::*axis;
};

constexpr PerTerm<TermRow> rows{{{
    {"noise", &slices::ps_main_key::bScrollingNoise},
    {"shadow", &slices::ps_main_key::bShadowMapping},
    {"cookie", &slices::ps_main_key::bCookie},
    {"scattering", &slices::ps_main_key::bScattering},
}}};

constexpr slices::ps_main_key keyOf(TermSet terms) {
    slices::ps_main_key key;
    for (const Term term : allTerms) key.*rows[term].axis = terms.contains(term);
    return key;
}

static_assert(std::ranges::all_of(allTermSets,
                                  [](TermSet terms) { return slices::find_technique(keyOf(terms)).has_value(); }),
              "slices.fx lacks the technique of a set of terms");
static_assert(slices::technique_count == TermSet::count, "slices.fx has an axis without a Term");

/// By TermSet::index().
constexpr auto techniques = [] {
    std::array<slices::TechniqueId, TermSet::count> found{};
    for (const TermSet terms : allTermSets) found[terms.index()] = *slices::find_technique(keyOf(terms));
    return found;
}();

}  // namespace

std::string_view nameOf(Term term) {
    return rows[term].name;
}

TermSet termsOf(const Light& light) {
    return TermSet()
        .with(Term::Noise, light.noise.has_value())
        .with(Term::Shadow, light.shadow)
        .with(Term::Cookie, light.cookie)
        .with(Term::Scattering, scatters(light));
}

Light keepOnly(Light light, TermSet terms) {
    if (!terms.contains(Term::Noise)) light.noise.reset();
    light.shadow = light.shadow && terms.contains(Term::Shadow);
    light.cookie = light.cookie && terms.contains(Term::Cookie);
    if (!terms.contains(Term::Scattering)) {
        light.anisotropy = 0.0;
        light.albedo.reset();
    }
    return light;
}

std::string_view techniqueName(TermSet terms) {
    return slices::technique(techniques[terms.index()]).name;
}

std::optional<TermSet> termsOf(std::string_view technique) {
    for (const TermSet terms : allTermSets)
        if (techniqueName(terms) == technique) return terms;
    return std::nullopt;
}

}  // namespace tyndall

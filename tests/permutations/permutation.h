// The permutations under test: all that slices.fx declares, read from permgen's tables.
#pragma once

#include <permgen/tables.h>
#include <tyndall/terms.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "draw.h"
#include "scenes.h"

namespace tyndall::test {

/// permgen's tables of slices.fx.
const permgen::Effect& effectTables();

/// Each term's switch in slices.fx, written down apart from the tables under test.
inline constexpr PerTerm<std::string_view> kSwitches{{"bScrollingNoise", "bShadowMapping", "bCookie", "bScattering"}};

struct Permutation {
    const permgen::Technique* technique;
    /// The terms in its name; for a technique that plan() does not know, those that its switches set.
    TermSet terms;
    /// plan() chooses it for a light with these terms. All others are drawn by name.
    bool chosen;
    /// The terms determine its picture: plan() may choose it, or every other switch that it has keeps the module's
    /// default. If another switch is set, tests only check that its picture is finite, repeatable, and the same frozen
    /// and specialized.
    bool predicted;

    std::string name() const { return std::string(technique->name); }
    std::string effect() const { return std::string(effectTables().name); }
    /// plan() can choose it with the article's constants: the published picture scatters evenly in clear air.
    bool drawsTheArticle() const { return !terms.contains(Term::Scattering); }
    const permgen::Pass& pass() const { return technique->passes[0]; }
    /// {"bCookie", "true"} and so on, both stages together.
    std::vector<std::pair<std::string, std::string>> constants() const;
};

/// One for each technique, in the effect's order.
std::vector<Permutation> permutations();

/// Those for the oracle, the masks and the laws, which concern the terms. Others are left out by their switches, never
/// by their names.
std::vector<Permutation> predictedPermutations();

/// The shot with the terms of the permutation alone.
Shot shotFor(const Permutation& permutation, const Shot& shot);

/// Draws that shot with that technique: plan() must choose it if it can; otherwise it replaces the one that plan()
/// chooses.
DrawOptions optionsFor(const Permutation& permutation, DrawOptions options = {});

/// For gtest's parameter names.
struct PermutationName {
    template <class Info>
    std::string operator()(const Info& info) const {
        return info.param.name();
    }
};

void PrintTo(const Permutation& permutation, std::ostream* out);

}  // namespace tyndall::test

// The permutations under test: whatever slices.fx declares, read from the tables permgen made of it.
#pragma once

#include <permgen/tables.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "draw.h"
#include "scenes.h"

namespace tyndall::test {

/// What permgen made of slices.fx.
const permgen::Effect& effectTables();

struct Permutation {
    const permgen::Technique* technique;
    /// The terms that its name promises; of a technique that plan() does not know, those its switches set.
    TermSet terms;
    /// plan() chooses it for a light with these terms. Every other is drawn by name.
    bool chosen;
    /// The terms say what it draws: plan() may choose it, or every further switch that it has stands where the
    /// shader's module leaves it. Of a switch that is set the tests know nothing but that it is drawn, the same
    /// every time, the same frozen as specialized, and finite.
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

/// Those for the oracle, the masks and the laws, which are about the terms; what else there is, is left out
/// by what its switches are, and never by its name.
std::vector<Permutation> predictedPermutations();

/// The shot with the terms of the permutation alone.
Shot shotFor(const Permutation& permutation, const Shot& shot);

/// Draws that shot with that technique: plan() has to come upon it where it can, and else it takes the place of
/// the one that plan() chooses.
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

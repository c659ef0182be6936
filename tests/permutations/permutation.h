// The permutations under test: whatever slices.fx declares, read from the tables permgen made of it.
#pragma once

#include <permgen/tables.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenes.h"

namespace tyndall::test {

/// What permgen made of slices.fx.
const permgen::Effect& effectTables();

struct Permutation {
    const permgen::Technique* technique;
    /// The terms that its name promises; of a technique that plan() does not know, those its switches set.
    bool noise, shadow, cookie;

    std::string name() const { return std::string(technique->name); }
    std::string effect() const { return std::string(effectTables().name); }
    const permgen::Pass& pass() const { return technique->passes[0]; }
    /// {"bCookie", "true"} and so on, both stages together.
    std::vector<std::pair<std::string, std::string>> constants() const;
};

/// One for each technique, in the effect's order.
std::vector<Permutation> permutations();

/// The one with these terms.
Permutation permutation(bool noise, bool shadow, bool cookie);

/// The shot with the terms of the permutation alone, so that planning it must lead to that technique.
Shot shotFor(const Permutation& permutation, const Shot& shot);

/// For gtest's parameter names.
struct PermutationName {
    template <class Info>
    std::string operator()(const Info& info) const {
        return info.param.name();
    }
};

void PrintTo(const Permutation& permutation, std::ostream* out);

}  // namespace tyndall::test

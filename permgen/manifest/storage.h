// The memory of a loaded effect's tables. Its elements never move.
#pragma once

#include <permgen/manifest.h>

#include <deque>
#include <string>
#include <tuple>
#include <vector>

namespace permgen {

struct LoadedEffect::Storage {
    Effect effect{};

    std::string_view keep(std::string text) { return texts_.emplace_back(std::move(text)); }

    /// Moving a vector leaves its elements where they are, and a deque's elements never move.
    template <class T>
    std::span<T> keep(std::vector<T> values) {
        return std::get<std::deque<std::vector<T>>>(arrays_).emplace_back(std::move(values));
    }

private:
    template <class... T>
    using Arrays = std::tuple<std::deque<std::vector<T>>...>;

    std::deque<std::string> texts_;
    Arrays<std::uint32_t, Constant, Attribute, State, Module, const Module*, Resource, const Resource*, Member, Pass,
           Technique>
        arrays_;
};

}  // namespace permgen

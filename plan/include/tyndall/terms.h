// The terms that the integrand of a light shaft may have, and sets of them. Each term is one switch of ps_main in
// slices.fx; each set is one permutation and has one technique. One more term is one more enumerator here, its row in
// plan/src/needs/terms.cpp, and its switch and techniques in the shader.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace tyndall {

struct Light;

/// In the order of ps_main's switches.
enum class Term : std::uint8_t {
    Noise,       ///< dust: two noise maps that drift over each other
    Shadow,      ///< occluders, by the light's shadow map
    Cookie,      ///< the projected texture
    Scattering,  ///< the air's phase function and extinction
};

inline constexpr std::array allTerms{Term::Noise, Term::Shadow, Term::Cookie, Term::Scattering};

/// "noise": as sentences name it.
std::string_view nameOf(Term term);

/// A set of terms: a value of a few bits.
class TermSet {
public:
    constexpr TermSet() = default;
    constexpr TermSet(std::initializer_list<Term> terms) {
        for (const Term term : terms) *this = with(term);
    }
    static constexpr TermSet all() { return TermSet(count - 1); }

    constexpr bool contains(Term term) const { return (bits_ & bitOf(term)) != 0; }
    constexpr bool empty() const { return bits_ == 0; }
    constexpr TermSet with(Term term, bool in = true) const {
        return TermSet(in ? bits_ | bitOf(term) : bits_ & ~bitOf(term));
    }
    constexpr TermSet without(Term term) const { return with(term, false); }
    /// The intersection.
    friend constexpr TermSet operator&(TermSet a, TermSet b) { return TermSet(unsigned{a.bits_} & b.bits_); }
    /// The union.
    friend constexpr TermSet operator|(TermSet a, TermSet b) { return TermSet(unsigned{a.bits_} | b.bits_); }
    friend constexpr bool operator==(TermSet, TermSet) = default;

    /// How many sets there are.
    static constexpr std::size_t count = std::size_t{1} << allTerms.size();
    /// 0 to count - 1. fromIndex() is the inverse; it takes the index modulo count.
    constexpr std::size_t index() const { return bits_; }
    static constexpr TermSet fromIndex(std::size_t index) { return TermSet(index % count); }

private:
    constexpr explicit TermSet(std::size_t bits) : bits_(static_cast<std::uint8_t>(bits)) {}
    static constexpr unsigned bitOf(Term term) { return 1u << static_cast<unsigned>(term); }
    static_assert(allTerms.size() <= 8);
    std::uint8_t bits_ = 0;
};

/// Every set once, by index: the whole key space of ps_main.
inline constexpr std::array<TermSet, TermSet::count> allTermSets = [] {
    std::array<TermSet, TermSet::count> sets;
    for (std::size_t i = 0; i < sets.size(); ++i) sets[i] = TermSet::fromIndex(i);
    return sets;
}();

/// One value for each term.
template <class T>
struct PerTerm {
    std::array<T, allTerms.size()> values{};
    constexpr T& operator[](Term term) { return values[static_cast<std::size_t>(term)]; }
    constexpr const T& operator[](Term term) const { return values[static_cast<std::size_t>(term)]; }
};

/// The terms that the light asks for. A view may need fewer.
TermSet termsOf(const Light& light);

/// The light with only those of its terms that are in `terms`. It gains none.
Light keepOnly(Light light, TermSet terms);

/// The technique of slices.fx, and of raycast.fx, that has exactly these terms, by its name in the effect.
std::string_view techniqueName(TermSet terms);

/// The terms of the technique of that name; absent where slices.fx has no such technique.
std::optional<TermSet> termsOf(std::string_view technique);

}  // namespace tyndall

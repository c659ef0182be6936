// The generated header's TechniqueId, keys and look-ups, at compile time and over the whole key space.
#include <gtest/gtest.h>
#include <keys.fx.h>
#include <slices.fx.h>

#include <array>
#include <bit>
#include <limits>
#include <type_traits>

namespace {

using keys::TechniqueId;

static_assert(keys::technique_count == 6);
static_assert(static_cast<int>(TechniqueId::two_passes) == 0 && static_cast<int>(TechniqueId::green) == 5);
static_assert(keys::technique(TechniqueId::again).name == "again");
static_assert(keys::technique(TechniqueId::new_).name == "new", "a keyword gets a trailing underscore");
static_assert(std::is_same_v<std::underlying_type_t<TechniqueId>, std::uint16_t>);

static_assert(std::is_same_v<decltype(keys::ps_main_key::bTint), bool>);
static_assert(std::is_same_v<decltype(keys::ps_main_key::nTaps), std::int32_t>);
static_assert(std::is_same_v<decltype(keys::ps_main_key::fGain), float>);
static_assert(std::is_same_v<decltype(keys::ps_main_key::noexcept_), std::uint32_t>);
static_assert(keys::ps_main_key{} == keys::ps_main_key{false, 0, 0.0f, 7u}, "the author's own defaults");
static_assert(keys::vs_main_key{}.fScale == 1.0f);

static_assert(keys::find_technique(keys::ps_main_key{true, -3, 1.5e-3f, 4294967295u}) == TechniqueId::two_passes);
static_assert(keys::find_technique(keys::ps_main_key{.bTint = false, .nTaps = 4, .fGain = 1e20f}) ==
                  TechniqueId::two_passes,
              "the second pass counts, and the first technique is taken");
static_assert(keys::find_technique(keys::ps_main_key{true, std::numeric_limits<std::int32_t>::min(), -0.5f}) ==
              TechniqueId::new_);
static_assert(keys::find_technique(keys::vs_main_key{}) == TechniqueId::new_, "a default argument is a key's value");
static_assert(keys::find_technique(keys::vs_main_key{2.0f}) == TechniqueId::two_passes);
static_assert(keys::find_technique(keys::vs_main_key{3.0f}) == TechniqueId::red);
static_assert(keys::find_technique(keys::ps_mixed_key{true}) == TechniqueId::red);
static_assert(keys::find_technique(keys::ps_mixed_2_key{true}) == TechniqueId::green,
              "another text of the entry point is a module of its own");

static_assert(!keys::find_technique(keys::ps_main_key{}), "an excluded permutation");
static_assert(!keys::find_technique(keys::ps_main_key{true, -3, 1.5e-3f}), "one axis away from a technique");
static_assert(!keys::find_technique(keys::ps_mixed_key{false}));
static_assert(!keys::find_technique(keys::vs_main_key{0.5f}));

static_assert(keys::ps_main_key_of(TechniqueId::two_passes) == keys::ps_main_key{true, -3, 1.5e-3f, 4294967295u});
static_assert(keys::ps_main_key_of(TechniqueId::again) == keys::ps_main_key{false, 4, 1e20f, 7u});
static_assert(!keys::ps_main_key_of(TechniqueId::plain), "no pass of it uses ps_main");
static_assert(keys::vs_main_key_of(TechniqueId::plain) == keys::vs_main_key{0.1f});

constexpr bool every_technique_is_found_by_its_key() {
    for (std::size_t i = 0; i < slices::technique_count; ++i) {
        const auto id = static_cast<slices::TechniqueId>(i);
        const auto key = slices::ps_main_key_of(id);
        if (!key || slices::find_technique(*key) != id) return false;
    }
    return true;
}
static_assert(every_technique_is_found_by_its_key());

TEST(Keys, AreTheBitsThatThePassIsCompiledWith) {
    for (std::size_t t = 0; t < keys::technique_count; ++t) {
        const auto id = static_cast<TechniqueId>(t);
        const permgen::Technique& technique = keys::technique(id);
        EXPECT_EQ(technique.name, keys::effect.techniques[t].name);
        const auto key = keys::vs_main_key_of(id);
        ASSERT_TRUE(key) << technique.name;
        EXPECT_EQ(std::bit_cast<std::uint32_t>(key->fScale), technique.passes[0].vertex.constants[0].bits)
            << technique.name;
    }
}

TEST(Keys, OfATechniqueLeadToATechniqueWithTheSameKey) {
    for (std::size_t t = 0; t < keys::technique_count; ++t) {
        const auto id = static_cast<TechniqueId>(t);
        if (const auto key = keys::ps_main_key_of(id)) {
            const auto found = keys::find_technique(*key);
            ASSERT_TRUE(found);
            EXPECT_LE(*found, id);
        }
    }
    EXPECT_EQ(keys::find_technique(*keys::ps_main_key_of(TechniqueId::again)), TechniqueId::two_passes);
}

}  // namespace

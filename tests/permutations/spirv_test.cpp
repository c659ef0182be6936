// Every module of slices.fx is valid and names the resources in its tables. The test reads the SPIR-V independently.
#include <back/validate.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "permutation.h"

namespace tyndall::test {
namespace {

struct Slot {
    std::uint32_t set = 0, binding = 0;
    auto operator<=>(const Slot&) const = default;
};

/// The descriptor slots of variables that instructions of the module's functions name: SPIR-V specification 1.6,
/// section 2.3, with OpDecorate 71, its decorations Binding 33 and DescriptorSet 34, OpVariable 59, OpFunction 54.
std::set<Slot> slotsUsed(std::span<const std::uint32_t> code) {
    std::map<std::uint32_t, Slot> slots;
    std::set<std::uint32_t> bound, used;
    bool inFunction = false;
    for (std::size_t at = 5; at < code.size(); at += code[at] >> 16) {
        const std::uint32_t opcode = code[at] & 0xffff, length = code[at] >> 16;
        if (length == 0 || at + length > code.size()) throw std::runtime_error("torn SPIR-V");
        inFunction = inFunction || opcode == 54;
        if (opcode == 71 && code[at + 2] == 33) {
            slots[code[at + 1]].binding = code[at + 3];
            bound.insert(code[at + 1]);
        }
        if (opcode == 71 && code[at + 2] == 34) slots[code[at + 1]].set = code[at + 3];
        // Any operand equal to the id counts; a literal that happens to equal it can only add a slot.
        for (std::uint32_t i = 1; inFunction && i < length; ++i)
            if (bound.contains(code[at + i])) used.insert(code[at + i]);
    }
    std::set<Slot> result;
    for (const std::uint32_t id : used) result.insert(slots[id]);
    return result;
}

class SpirvTest : public testing::TestWithParam<Permutation> {};

INSTANTIATE_TEST_SUITE_P(SlicesFx, SpirvTest, testing::ValuesIn(permutations()), PermutationName());

TEST(Spirv, SharedModulesAreValid) {
    for (const permgen::Module* module : effectTables().modules) {
        ASSERT_FALSE(module->code.empty()) << module->name;
        EXPECT_EQ(permgen::validate_spirv(module->code), "") << module->name;
    }
}

TEST_P(SpirvTest, FrozenModulesAreValidAndUseExactlyWhatIsLive) {
    for (const permgen::Pass& pass : GetParam().technique->passes) {
        std::set<Slot> live, used;
        for (const permgen::Resource* resource : pass.live) live.insert({resource->set, resource->binding});
        for (const permgen::Shader* shader : {&pass.vertex, &pass.pixel}) {
            if (!shader->module) continue;
            ASSERT_FALSE(shader->frozen.empty()) << shader->module->name;
            EXPECT_EQ(permgen::validate_spirv(shader->frozen), "") << shader->module->name;
            used.merge(slotsUsed(shader->frozen));
        }
        EXPECT_EQ(used, live) << pass.name;
    }
}

// The technique's name must match its switches.
TEST_P(SpirvTest, ItsSwitchesAreWhatItsNameSays) {
    for (const permgen::Constant& constant : GetParam().pass().pixel.constants)
        for (const Term term : allTerms)
            if (constant.name == kSwitches[term]) {
                EXPECT_EQ(constant.bits != 0, GetParam().terms.contains(term)) << constant.name;
            }
}

}  // namespace
}  // namespace tyndall::test

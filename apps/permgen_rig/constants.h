// The bytes of an effect's uniform blocks, filled from a fixture.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "block_layout.h"
#include "fixture.h"

namespace tyndall::rig {

/// All blocks, by name; 0 for constants that the fixture does not set.
using Blocks = std::map<std::string, std::vector<std::byte>, std::less<>>;

struct Constants {
    Blocks blocks;
    std::vector<std::string> unset;  ///< members that the fixture leaves at 0
};

/// Errors: a constant that the effect does not have (with the nearest name), of another count, or not a whole
/// number for an integer type.
Result<Constants> fillConstants(const permgen::Effect& effect, const std::vector<BlockMember>& members,
                                const Fixture& fixture);

/// The same block with every number changed: a picture that depends on one of them must change.
std::vector<std::byte> altered(const std::vector<BlockMember>& members, std::string_view block,
                               std::vector<std::byte> bytes);

}  // namespace tyndall::rig

// What the library's C++ takes for granted of its effects: asserted at compile time of those built in, checked
// of those that a caller brings.
#pragma once

#include <permgen/tables.h>
#include <tyndall/device.h>
#include <tyndall/pass_pipelines.h>
#include <tyndall/result.h>

#include <cstddef>
#include <span>
#include <string_view>

namespace tyndall {

/// What permgen calls the block of an effect's global variables.
inline constexpr std::string_view globalsBlock = "Globals";

struct BlockMember {
    std::string_view name;
    std::size_t offset, size;  ///< bytes
};

struct EffectContract {
    std::string_view file;
    std::span<const BlockMember> members;          ///< of its only uniform block, globalsBlock
    std::size_t blockSize;                         ///< bytes
    std::span<const std::string_view> samplers;    ///< of 2D images; it may do with fewer
    std::span<const std::string_view> techniques;  ///< each of one pass; it may have more
    std::span<const VertexElement> elements;
    bool pixels;  ///< passes have pixel shaders
};

const EffectContract& slicesContract();
const EffectContract& compositeContract();
const EffectContract& shadowMapContract();

/// Errors: InvalidArgument naming the effect and what in it does not fit.
Result<void> checkEffect(const permgen::Effect& effect, const EffectContract& contract, Shaders shaders);

}  // namespace tyndall

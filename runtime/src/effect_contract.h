// What the library's C++ expects of its effects: asserted at compile time for built-in ones, checked for those that a
// caller gives.
#pragma once

#include <permgen/tables.h>
#include <tyndall/device.h>
#include <tyndall/pass_pipelines.h>
#include <tyndall/result.h>

#include <cstddef>
#include <span>
#include <string_view>

namespace tyndall {

/// permgen's name for the block of an effect's global variables.
inline constexpr std::string_view globalsBlock = "Globals";

struct BlockMember {
    std::string_view name;
    std::size_t offset, size;  ///< bytes
};

struct EffectContract {
    std::string_view file;
    std::span<const BlockMember> members;          ///< of its only uniform block, globalsBlock
    std::size_t blockSize;                         ///< bytes
    std::span<const std::string_view> samplers;    ///< of 2D images; the effect may have fewer
    std::span<const std::string_view> techniques;  ///< each has one pass; the effect may have more
    std::span<const VertexElement> elements;
    bool pixels;  ///< passes have pixel shaders
};

const EffectContract& slicesContract();
const EffectContract& raycastContract();
const EffectContract& compositeContract();
const EffectContract& shadowMapContract();
const EffectContract& shadowHierarchyContract();

/// Errors: InvalidArgument naming the effect and the part that does not fit.
Result<void> checkEffect(const permgen::Effect& effect, const EffectContract& contract, Shaders shaders);

}  // namespace tyndall

// An effect after compilation: the lowered effect, its SPIR-V, and its live resources. Plain data between compile,
// specialize, link and emit.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "back/reflect.h"
#include "lower/lowered.h"

namespace permgen {

using SpirvWords = std::vector<std::uint32_t>;

/// One entry point's SPIR-V with its switches still open.
struct CompiledModule {
    SpirvWords code;
    Reflection reflection;
};

/// The same with a pass's switches set and without dead code; `code` empty: the pass has no such stage.
struct FrozenShader {
    SpirvWords code;
    Reflection reflection;
};

struct BuiltPass {
    FrozenShader vertex;
    FrozenShader pixel;
    FrozenShader compute;
    std::vector<std::size_t> live;  ///< indices into Lowered::resources, ascending
};

struct Program {
    Lowered effect;
    std::vector<CompiledModule> modules;         ///< as Lowered::modules
    std::vector<std::vector<BuiltPass>> passes;  ///< [technique][pass], as in Lowered
    std::vector<std::uint32_t> resource_sizes;   ///< as Lowered::resources; bytes of a block or element, else 0
    std::vector<ReflectedMember> members;        ///< of every block and element, in the order of resources and offsets
};

}  // namespace permgen

// The generated entry point: it declares the specialization constants and the stage's interface, and calls the author's
// function.
#pragma once

#include <array>

#include "lower/lower_arguments.h"
#include "lower/lower_interface.h"
#include "lower/lower_text.h"

namespace permgen {

/// An entry point to generate: its bound uniforms and its registers.
struct EntryPoint {
    std::string name;  ///< the module's, unique in the effect
    Stage stage;
    std::string profile;
    BoundEntry bound;
    std::vector<InterfaceSlot> inputs;
    std::vector<InterfaceSlot> outputs;
    std::array<std::uint32_t, 3> group_size{};  ///< of a compute shader
};

/// Fills in the registers.
void find_interface(const ParsedEffect& effect, const Sources& sources, EntryPoint& entry, Diagnostics& diagnostics);

/// The finished module: `author`, followed by the wrapper.
LoweredModule make_module(const ParsedEffect& effect, const Sources& sources, const EntryPoint& entry,
                          const LocationTable& locations, LoweredText author);

}  // namespace permgen

// The generated entry point: specialization constants and the stage's interface on the outside, a call of the
// author's function within.
#pragma once

#include "lower/lower_arguments.h"
#include "lower/lower_interface.h"
#include "lower/lower_text.h"

namespace permgen {

/// One entry point to be: what is bound to its uniforms, and its registers.
struct EntryPoint {
    std::string name;  ///< the module's, unique in the effect
    Stage stage;
    std::string profile;
    BoundEntry bound;
    std::vector<InterfaceSlot> inputs;
    std::vector<InterfaceSlot> outputs;
};

/// Fills in the registers.
void find_interface(const ParsedEffect& effect, const Sources& sources, EntryPoint& entry, Diagnostics& diagnostics);

/// The finished module: `author`, with the wrapper behind it.
LoweredModule make_module(const ParsedEffect& effect, const Sources& sources, const EntryPoint& entry,
                          const LocationTable& locations, LoweredText author);

}  // namespace permgen

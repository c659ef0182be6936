// `permgen list`: the techniques of an effect, what they set and what they need.
#pragma once

#include <string>

#include "back/program.h"

namespace permgen {

std::string list_json(const Program& program);

/// For people: one line a pass.
std::string list_table(const Program& program);

}  // namespace permgen

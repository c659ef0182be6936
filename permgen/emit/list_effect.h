// `permgen list`: the techniques of an effect, their constants and their live resources.
#pragma once

#include <string>

#include "back/program.h"

namespace permgen {

std::string list_json(const Program& program);

/// A table for people: one line per pass.
std::string list_table(const Program& program);

}  // namespace permgen

// A plan in words.
#pragma once

#include <tyndall/plan.h>

#include <string>
#include <vector>

namespace tyndall {

/// Why the light is drawn as it is, or not at all: one sentence.
std::string reason(const PlannedLight& light, const View& view);

/// What was left out of a drawn light, and why: one sentence for each; empty where nothing was.
std::vector<std::string> savings(const PlannedLight& light);

}  // namespace tyndall

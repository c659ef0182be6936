// The page of failures, made of every entry there is.
#pragma once

#include <string>

namespace tyndall::rig {

/// HTML with everything in it: no script, no style sheet and no picture is fetched. Entries that cannot be read
/// are named instead of shown.
std::string reportPage(const std::string& entriesFolder);

}  // namespace tyndall::rig

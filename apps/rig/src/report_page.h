// The page of failures, made of every entry there is.
#pragma once

#include <string>
#include <string_view>

namespace tyndall::rig {

/// Ends the title of every such page, and so tells one from a page that somebody else wrote.
inline constexpr std::string_view pageMark = " failing comparisons</title>";

/// HTML with everything in it: no script, no style sheet and no picture is fetched. Entries that cannot be read
/// are named instead of shown.
std::string reportPage(const std::string& entriesFolder);

}  // namespace tyndall::rig

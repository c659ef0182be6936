// The page of failures, made of every entry there is.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall::rig {

/// Ends the title of every such page, and so tells one from a page that somebody else wrote.
inline constexpr std::string_view pageMark = " failing comparisons</title>";

/// HTML with everything in it: no script, no style sheet and no picture is fetched. Entries that cannot be read
/// are named instead of shown.
std::string reportPage(const std::string& entriesFolder);

/// The folders of entries that are about the effect, but none of these techniques.
std::vector<std::filesystem::path> entriesOfOtherTechniques(const std::string& entriesFolder, const std::string& effect,
                                                            const std::vector<std::string>& techniques);

}  // namespace tyndall::rig

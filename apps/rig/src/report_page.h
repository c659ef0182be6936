// The page of failures, made from all entries.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall::rig {

/// The end of the title of every such page; other pages do not have it.
inline constexpr std::string_view pageMark = " failing comparisons</title>";

/// Self-contained HTML: it fetches no script, style sheet or picture. Entries that cannot be read
/// are named instead of shown.
std::string reportPage(const std::string& entriesFolder);

/// The folders of the effect's entries whose technique is not in the list.
std::vector<std::filesystem::path> entriesOfOtherTechniques(const std::string& entriesFolder, const std::string& effect,
                                                            const std::vector<std::string>& techniques);

}  // namespace tyndall::rig

// One failure as files.
#pragma once

#include <rig/report.h>

#include <filesystem>

namespace tyndall::rig {

/// Fills the folder, which exists, with the failure's pictures and entry.json.
Result<void> writeEntry(const std::filesystem::path& folder, const Failure& failure, const Image* image,
                        const Image* expected);

}  // namespace tyndall::rig

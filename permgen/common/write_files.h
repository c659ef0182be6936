// Writes all files or none.
#pragma once

#include <permgen/error.h>

#include <string>
#include <vector>

namespace permgen {

struct OutputFile {
    std::string path;
    std::string bytes;
};

/// Writes every file to a temporary name in its folder and renames all of them once the last is complete; makes missing
/// folders. A file that already holds the same bytes keeps its time stamp. Errors: ErrorCode::File; the folder is
/// then unchanged.
Result<void> write_files(const std::vector<OutputFile>& files);

}  // namespace permgen

// Writes all files or none.
#pragma once

#include <string>
#include <vector>

namespace permgen {

struct OutputFile {
    std::string path;
    std::string bytes;
};

/// Writes every file to a temporary name in its folder and renames all of them once the last is complete; makes missing
/// folders. A file that already holds the same bytes keeps its time stamp. Returns an empty string, or one sentence
/// about the error; the folder is then unchanged.
std::string write_files(const std::vector<OutputFile>& files);

}  // namespace permgen

// All files or none.
#pragma once

#include <string>
#include <vector>

namespace permgen {

struct OutputFile {
    std::string path;
    std::string bytes;
};

/// Writes every file beside its place and moves all of them there once the last is complete, making
/// missing folders. A file that already holds the same bytes is left alone, time stamp included. Returns an
/// empty string, or one sentence that says what went wrong; the folder is then as it was before.
std::string write_files(const std::vector<OutputFile>& files);

}  // namespace permgen

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
/// empty string, or one sentence saying what went wrong; then whatever was there before still is, and
/// nothing of ours is left behind.
std::string write_files(const std::vector<OutputFile>& files);

}  // namespace permgen

// Atomic writing of files: to a temporary name and then renamed, so that no reader sees a partial file. A link is
// followed: the file that it names is written.
#pragma once

#include <kit/fail.h>

#include <string>
#include <string_view>

namespace tyndall {

/// Whether a file can be made at `path`. Call it before the work that makes the file's content.
Result<void> checkWritable(const std::string& path);

/// Whether writing `a` would change `b`, through links too. The files need not exist.
bool sameFile(const std::string& a, const std::string& b);

/// Writes `bytes` as the whole file. Its folder must exist. Errors: a place that cannot be written; an older
/// file is then unchanged.
Result<void> writeFile(const std::string& path, std::string_view bytes);

}  // namespace tyndall

// Files written whole: beside their place and then renamed, so that nobody meets half of one. A link is followed: the
// file that it names is written.
#pragma once

#include <kit/fail.h>

#include <string>
#include <string_view>

namespace tyndall {

/// Whether a file can be made at `path`, to be asked before the work of filling it begins.
Result<void> checkWritable(const std::string& path);

/// Whether writing `a` would change `b`, through links too; what does not exist yet can still be the same.
bool sameFile(const std::string& a, const std::string& b);

/// Writes `bytes` as the whole file. Its folder must exist. Errors: a place that cannot be written; the file that was
/// there before is then unchanged.
Result<void> writeFile(const std::string& path, std::string_view bytes);

}  // namespace tyndall

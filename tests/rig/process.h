// Runs a program and keeps its output.
#pragma once

#include <string>
#include <vector>

namespace tyndall::test {

struct Ran {
    int status = -1;   ///< exit status; 128 + the signal that ended it
    std::string text;  ///< both outputs
};

Ran runProgram(const std::vector<std::string>& words);

/// Compiles the effect's text, frozen modules included, to `folder`/`name`.fx.json, whose path it returns. Throws
/// permgen's message if it does not compile.
std::string compileEffect(const std::string& folder, const std::string& name, const std::string& text,
                          const std::vector<std::string>& options = {});

/// Replaces the one occurrence; throws if there are none or several.
std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace tyndall::test

// Parses the command line.
#pragma once

#include <string>
#include <variant>

#include "options.h"

namespace tyndall::app {

/// The text of --help or --version.
struct Help {
    std::string text;
};

using Request = std::variant<RenderOptions, ExplainOptions, ReferenceOptions, CompareOptions, Help>;

/// Errors: the command line is wrong; the message says how to correct it.
Result<Request> parseCommandLine(int argc, const char* const* argv);

}  // namespace tyndall::app

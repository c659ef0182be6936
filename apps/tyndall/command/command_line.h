// What the command line asks for.
#pragma once

#include <string>
#include <variant>

#include "options.h"

namespace tyndall::app {

/// Text that was asked for (--help, --version).
struct Help {
    std::string text;
};

using Request = std::variant<RenderOptions, ExplainOptions, ReferenceOptions, CompareOptions, Help>;

/// Errors: the command line is wrong, and how to say it right.
Result<Request> parseCommandLine(int argc, const char* const* argv);

}  // namespace tyndall::app

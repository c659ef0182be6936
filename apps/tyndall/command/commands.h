// The program's commands, after the command line was understood. They return; main() prints and exits.
#pragma once

#include <string>

#include "../options.h"

namespace tyndall::app {

/// What a command has to say: `output` is its result (standard output), `notes` go beside it.
struct Said {
    std::string output;
    std::vector<std::string> notes;
};

Outcome<Said> render(const RenderOptions& options);
Outcome<Said> explain(const ExplainOptions& options);

}  // namespace tyndall::app

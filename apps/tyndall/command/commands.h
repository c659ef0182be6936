// The program's commands, after the command line was understood. They return; main() prints and exits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options.h"
#include "../progress.h"

namespace tyndall::app {

/// What a command has to say: `output` is its result (standard output), `notes` go beside it. `verdict`, where
/// there is one, says what the result fails: the work was done, and its answer is no.
struct CommandOutput {
    std::string output;
    std::vector<std::string> notes;
    std::optional<std::string> verdict = std::nullopt;
};

Result<CommandOutput> render(const RenderOptions& options);
Result<CommandOutput> explain(const ExplainOptions& options);
/// `progress` is asked now and then whether to go on.
Result<CommandOutput> reference(const ReferenceOptions& options, const Progress& progress);
Result<CommandOutput> compare(const CompareOptions& options);

}  // namespace tyndall::app

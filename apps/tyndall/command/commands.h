// The program's commands, after parsing. They return; main() prints and exits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "../progress.h"
#include "options.h"

namespace tyndall::app {

/// A command's output: `output` is its result (standard output), `notes` go to standard error. `verdict`, if present,
/// says which limit the result fails: the work was done, but the result is too bad.
struct CommandOutput {
    std::string output;
    std::vector<std::string> notes;
    std::optional<std::string> verdict = std::nullopt;
};

Result<CommandOutput> render(const RenderOptions& options);
Result<CommandOutput> explain(const ExplainOptions& options);
/// `progress` is called regularly; false stops the work.
Result<CommandOutput> reference(const ReferenceOptions& options, const Progress& progress);
Result<CommandOutput> compare(const CompareOptions& options);

}  // namespace tyndall::app

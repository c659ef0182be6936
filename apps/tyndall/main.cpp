// tyndall: light shafts from glTF scenes. Exit status: 0 done, 1 the work failed, 2 the command line is wrong.
#include <fmt/core.h>

#include <exception>

#include "command/command_line.h"
#include "command/commands.h"
#include "progress.h"

namespace {

using namespace tyndall::app;

int fails(int status, const std::string& sentence) {
    fmt::print(stderr, "tyndall: error: {}\n", sentence);
    return status;
}

tyndall::Result<CommandOutput> run(const Request& request) {
    if (const auto* options = std::get_if<RenderOptions>(&request)) return render(*options);
    if (const auto* options = std::get_if<ExplainOptions>(&request)) return explain(*options);
    if (const auto* options = std::get_if<ReferenceOptions>(&request)) {
        Watch watch("reference");
        return reference(*options, [&watch](double share) { return watch.report(share); });
    }
    if (const auto* options = std::get_if<CompareOptions>(&request)) return compare(*options);
    return CommandOutput{std::get<Help>(request).text, {}};
}

}  // namespace

int main(int argc, char** argv) try {
    const auto request = parseCommandLine(argc, argv);
    if (!request) return fails(2, request.error().message);
    const auto output = run(*request);
    if (!output) return fails(1, output.error().message);
    for (const std::string& note : output->notes) fmt::print(stderr, "tyndall: {}\n", note);
    fmt::print("{}", output->output);
    return output->verdict ? fails(1, *output->verdict) : 0;
} catch (const std::bad_alloc&) {
    return fails(1, "there is not enough memory; take a smaller picture or a smaller scene");
} catch (const std::exception& unforeseen) {
    return fails(1, unforeseen.what());
}

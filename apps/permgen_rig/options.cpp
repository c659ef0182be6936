#include "options.h"

#include <CLI/CLI.hpp>

namespace tyndall::rig {

int parseOptions(int argc, char** argv, Options& options) {
    CLI::App app(
        "permgen-rig: draws every technique and pass of an effect, and compares them with each other and with "
        "goldens.\n"
        "Exit status 0: everything passed; 1: something failed; 2: nothing could be tested; a message says why.",
        "permgen-rig");
    app.set_version_flag("--version", std::string("permgen-rig ") + PERMGEN_VERSION);
    const auto notEmpty =
        CLI::Validator([](const std::string& text) { return text.empty() ? "this cannot be empty" : ""; }, "");
    app.add_option("MANIFEST", options.manifest, "NAME.fx.json, as permgen compile --freeze writes it, or its folder")
        ->required()
        ->check(notEmpty);
    auto* fixture =
        app.add_option("FIXTURE", options.fixture, "JSON: textures, constants, geometry and target")->check(notEmpty);
    auto* goldens = app.add_option("--goldens", options.goldens, "folder of golden images to compare with")
                        ->type_name("DIR")
                        ->check(notEmpty);
    app.add_flag("--update-goldens", options.updateGoldens, "write missing and different goldens; the run still fails")
        ->needs(goldens);
    app.add_option("--report", options.report, "folder for failures: pictures, figures and one index.html")
        ->type_name("DIR")
        ->check(notEmpty);
    app.add_option("--technique", options.technique, "test only this one")->type_name("NAME")->check(notEmpty);
    app.add_option("--device", options.device, "part of a Vulkan device's name; default: lavapipe before a GPU")
        ->type_name("NAME");
    auto* list = app.add_flag("--list", options.list, "write the techniques' names, one a line, and draw nothing");
    try {
        app.parse(argc, argv);
        if (!*list && !*fixture) throw CLI::RequiredError("FIXTURE");
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return -1;
}

}  // namespace tyndall::rig

#include "command_line.h"

#include "add_options.h"

namespace tyndall::app {
namespace {

/// Options as written, before they are checked together.
struct Written {
    std::string size = "640x360";
    RenderOptions render;
    ExplainOptions explain;
    ReferenceOptions reference;
    CompareOptions compare;
};

/// The parser's message, unless it would only repeat the input.
std::string wrongLine(const CLI::App& app, const CLI::ParseError& wrong, int argc, const char* const* argv) {
    std::string names;
    const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
    for (const CLI::App* command : commands) names += (names.empty() ? "" : ", ") + command->get_name();
    if (argc < 2) return fmt::format("give a command: {}; see tyndall --help", names);
    const bool known = std::any_of(commands.begin(), commands.end(),
                                   [&](const CLI::App* command) { return command->get_name() == argv[1]; });
    if (!known && argv[1][0] != '-')
        return fmt::format("there is no command \"{}\"; take one of {}, or see tyndall --help", argv[1], names);
    return fmt::format("{}; see tyndall --help", wrong.what());
}

template <class Options>
Result<Request> accept(Result<void> checked, const Options& options) {
    if (!checked) return tl::unexpected(checked.error());
    return Request(options);
}

}  // namespace

Result<Request> parseCommandLine(int argc, const char* const* argv) {
    Written written;
    CLI::App app("Light shafts from glTF scenes.", "tyndall");
    app.require_subcommand(1);
    app.set_version_flag("--version", "tyndall " TYNDALL_VERSION "\n");
    CLI::App* render = app.add_subcommand("render", "draws a scene with its light shafts");
    addRender(*render, written.render, written.size);
    CLI::App* explain = app.add_subcommand("explain", "describes what would be drawn, and why");
    addExplain(*explain, written.explain, written.size);
    CLI::App* reference = app.add_subcommand("reference", "computes a scene's shafts with high accuracy");
    addReference(*reference, written.reference, written.size);
    CLI::App* compare = app.add_subcommand("compare", "measures the difference of a picture and its reference");
    addCompare(*compare, written.compare);

    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForVersion& version) {
        return Help{version.what()};
    } catch (const CLI::Success& asked) {  // --help
        for (const CLI::App* command : {render, explain, reference, compare})
            if (command->parsed()) return Help{command->help("tyndall")};
        return Help{app.help()};
    } catch (const CLI::ParseError& wrong) {
        return failWith(wrongLine(app, wrong, argc, argv));
    }

    if (compare->parsed()) return accept(checkCompare(written.compare), written.compare);
    ViewOptions& view = render->parsed()    ? written.render.view
                        : explain->parsed() ? written.explain.view
                                            : written.reference.view;
    if (auto checked = checkView(view, written.size); !checked) return tl::unexpected(checked.error());
    if (reference->parsed())
        return accept(checkReference(written.reference, reference->count("--shadow-size") > 0), written.reference);
    if (explain->parsed()) return accept(checkShafts(written.explain.shafts, written.explain.slices), written.explain);
    auto checked = checkRender(written.render, render->count("--output") > 0);
    return accept(std::move(checked), written.render);
}

}  // namespace tyndall::app

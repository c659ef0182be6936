#include "command_line.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <map>

#include "../image/write_picture.h"
#include "words.h"

namespace tyndall::app {
namespace {

/// Options as written, before they are checked together.
struct Written {
    std::string size = "640x360";
    RenderOptions render;
    ExplainOptions explain;
};

template <class T, std::size_t N>
CLI::Option* addChoice(CLI::App& app, const char* name, T& value, const Words<T, N>& words, const std::string& help) {
    std::map<std::string, T> meanings;
    std::string list;
    for (const auto& [word, meaning] : words) {
        meanings.emplace(word, meaning);
        list += (list.empty() ? "" : ", ") + std::string(word);
    }
    return app
        .add_option_function<std::string>(
            name,
            [&value, meanings, list, name](const std::string& text) {
                const auto found = meanings.find(text);
                if (found == meanings.end())
                    throw CLI::ValidationError(fmt::format("{}: \"{}\" is none of {}", name, text, list));
                value = found->second;
            },
            fmt::format("{}: {}", help, list))
        ->type_name("NAME");
}

template <class T>
void addOptional(CLI::App& app, const char* name, std::optional<T>& value, const char* type, const char* help) {
    app.add_option_function<T>(
           name, [&value](const T& given) { value = given; }, help)
        ->type_name(type);
}

void addViewOptions(CLI::App& app, ViewOptions& view, std::string& size) {
    app.add_option("scene", view.scene, "glTF file, .glb or .gltf")->required()->type_name("SCENE");
    addOptional(app, "--camera", view.camera, "NAME", "camera to look through; the file's first");
    app.add_option("--size", size, "width and height in pixels; 640x360")->type_name("WxH");
    app.add_option("--time", view.time, "moment of the animations, seconds; 0")->type_name("S");
    addChoice(app, "--layer", view.layer, layerWords, "what to draw");
}

void addShaftOptions(CLI::App& app, ShaftOptions& shafts) {
    addOptional(app, "--technique", shafts.technique, "NAME", "technique of slices.fx for every light");
    addChoice(app, "--accum", shafts.accumulation, accumulationWords, "where slices are added up");
    app.add_option("--planes", shafts.planes, "slices a light, 1 to 65536; 100")->type_name("N");
    addChoice(app, "--geometry", shafts.geometry, geometryWords, "how slices become triangles");
    addChoice(app, "--look", shafts.look, lookWords, "constants that weigh a slice");
    addOptional(app, "--range", shafts.range, "R",
                "radiance that 8-bit targets call 1; an upper estimate from the lights");
    app.add_option("--shadow-size", shafts.shadowSize, "texels a side of a shadow map, 1 to 16384; 1024")
        ->type_name("N");
}

Outcome<void> checkView(ViewOptions& view, const std::string& size) {
    const auto parsed = parseSize(size);
    if (!parsed) return tl::unexpected(parsed.error());
    view.size = *parsed;
    if (!std::isfinite(view.time)) return fail("--time: must be a finite number of seconds");
    return {};
}

Outcome<void> checkShafts(const ShaftOptions& shafts) {
    if (shafts.planes < 1 || shafts.planes > 65536)
        return fail("--planes: {} is out of bounds; take from 1 to 65536", shafts.planes);
    if (shafts.accumulation == Accumulation::Rgba8Routed && shafts.planes % 4 != 0)
        return fail(
            "--planes: {} slices cannot be spread evenly over four channels; with --accum rgba8-routed take a "
            "multiple of 4",
            shafts.planes);
    if (shafts.shadowSize < 1 || shafts.shadowSize > longestSide)
        return fail("--shadow-size: {} is out of bounds; take from 1 to {}", shafts.shadowSize, longestSide);
    if (shafts.range && !(*shafts.range > 0.0 && std::isfinite(*shafts.range)))
        return fail("--range: must be a radiance above 0");
    return shafts.technique ? checkTechnique(*shafts.technique) : Outcome<void>{};
}

Outcome<void> checkRender(RenderOptions& render) {
    if (render.output.empty())
        render.output = std::filesystem::path(render.view.scene).stem().string() +
                        (render.view.layer == Layer::Shafts ? ".exr" : ".png");
    const auto format = pictureFormat(render.output);
    if (!format)
        return fail("-o: {} is neither .png nor .exr; give the picture one of these extensions", render.output);
    if (render.view.layer == Layer::Shafts && *format != PictureFormat::Exr)
        return fail("-o: {} cannot hold --layer shafts, which is radiance without limits; write an .exr",
                    render.output);
    if (render.exposure && !(std::abs(*render.exposure) <= 64.0))
        return fail("--exposure: must lie between -64 and 64 stops");
    return {};
}

}  // namespace

Outcome<Request> parseCommandLine(int argc, const char* const* argv) {
    Written written;
    CLI::App app("Light shafts from glTF scenes.", "tyndall");
    app.require_subcommand(1);
    CLI::App* render = app.add_subcommand("render", "draws a scene with its light shafts");
    addViewOptions(*render, written.render.view, written.size);
    addShaftOptions(*render, written.render.shafts);
    render->add_option("-o,--output", written.render.output, "picture to write, .png (tone-mapped) or .exr (linear)")
        ->type_name("IMAGE");
    addOptional(*render, "--exposure", written.render.exposure, "EV",
                "stops by which a .png is brightened; from the picture's log-average");
    addOptional(*render, "--stats", written.render.stats, "FILE.json", "what was drawn, and what it took");
    render->add_flag("--validate", written.render.validate, "fail on any message of Vulkan's validation layers");
    CLI::App* explain = app.add_subcommand("explain", "says what would be drawn, and why");
    addViewOptions(*explain, written.explain.view, written.size);
    addShaftOptions(*explain, written.explain.shafts);
    explain->add_flag("--json", written.explain.json, "as JSON");

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help
        const CLI::App* about = render->parsed() ? render : explain->parsed() ? explain : &app;
        return Help{about->help()};
    } catch (const CLI::ParseError& wrong) {
        return fail("{}; see tyndall --help", wrong.what());
    }

    ViewOptions& view = render->parsed() ? written.render.view : written.explain.view;
    const ShaftOptions& shafts = render->parsed() ? written.render.shafts : written.explain.shafts;
    if (auto checked = checkView(view, written.size); !checked) return tl::unexpected(checked.error());
    if (auto checked = checkShafts(shafts); !checked) return tl::unexpected(checked.error());
    if (!render->parsed()) return written.explain;
    if (render->count("--output") > 0 && written.render.output.empty())
        return fail("-o: the picture's name is empty; give one, or leave -o out");
    if (auto checked = checkRender(written.render); !checked) return tl::unexpected(checked.error());
    return written.render;
}

}  // namespace tyndall::app

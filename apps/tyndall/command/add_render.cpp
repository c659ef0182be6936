#include <cmath>
#include <filesystem>

#include <kit/image/write_picture.h>
#include "add_options.h"

namespace tyndall::app {
namespace {

void addShafts(CLI::App& app, ViewOptions& view, ShaftOptions& shafts) {
    addChoice(app, "--layer", view.layer, layerWords, "what to draw");
    addTechnique(app, shafts.terms, "technique of slices.fx for every light");
    addChoice(app, "--accum", shafts.accumulation, accumulationWords, "where slices are added up");
    addOptional(app, "--planes", shafts.planes, "N", "so many equal slices a light, 1 to 65536; as many as needed");
    addOptional(app, "--most-slices", shafts.mostSlices, "N",
                "where they are as many as needed, not more a light than that, 1 to 65536; 256");
    addChoice(app, "--geometry", shafts.geometry, geometryWords, "how slices become triangles");
    addChoice(app, "--look", shafts.look, lookWords, "constants that weigh a slice");
    addOptional(app, "--range", shafts.range, "R",
                "radiance that 8-bit targets call 1; estimated from above from the lights");
    addShadowSize(app, shafts.shadowSize);
    addOptional(app, "--exposure", shafts.exposure, "EV",
                "stops by which a .png is brightened; from the picture's log-average");
    app.add_flag("--force-all", shafts.everything, "leave nothing out, to compare with: every light with every term");
}

}  // namespace

void addRender(CLI::App& app, RenderOptions& options, std::string& size) {
    addViewOptions(app, options.view, size);
    addShafts(app, options.view, options.shafts);
    app.add_option("-o,--output", options.output, "picture to write, .png (tone-mapped) or .exr (linear)")
        ->type_name("IMAGE");
    addOptional(app, "--stats", options.stats, "FILE.json", "what was drawn, and what it took");
    addOptional(app, "--pipeline-cache", options.pipelineCache, "FILE",
                "where pipelines are kept between runs, or none; tyndall/ in the user's cache folder");
    app.add_flag("--validate", options.validate, "fail on any message of Vulkan's validation layers");
}

void addExplain(CLI::App& app, ExplainOptions& options, std::string& size) {
    addViewOptions(app, options.view, size);
    addShafts(app, options.view, options.shafts);
    app.add_flag("--json", options.json, "as JSON");
}

Result<void> checkShafts(const ShaftOptions& shafts) {
    if (shafts.planes && (*shafts.planes < 1 || *shafts.planes > 65536))
        return fail("--planes: {} is out of bounds; take from 1 to 65536", *shafts.planes);
    if (shafts.mostSlices && (*shafts.mostSlices < 1 || *shafts.mostSlices > 65536))
        return fail("--most-slices: {} is out of bounds; take from 1 to 65536", *shafts.mostSlices);
    if (shafts.mostSlices && (shafts.planes || shafts.look == Look::Article))
        return fail("--most-slices: bounds slices that are as many as needed; leave {} out",
                    shafts.planes ? "--planes" : "--look article");
    if (shafts.planes && shafts.accumulation == Accumulation::Rgba8Routed && *shafts.planes % 4 != 0)
        return fail(
            "--planes: {} slices cannot be spread evenly over four channels; with --accum rgba8-routed take a "
            "multiple of 4",
            *shafts.planes);
    if (shafts.exposure && !(std::abs(*shafts.exposure) <= 64.0))
        return fail("--exposure: must lie between -64 and 64 stops");
    if (shafts.everything && shafts.terms)
        return fail("--force-all: draws with the full technique; leave --technique out");
    if (auto checked = checkShadowSize(shafts.shadowSize); !checked) return checked;
    if (shafts.range && !(*shafts.range > 0.0 && std::isfinite(*shafts.range)))
        return fail("--range: must be a radiance above 0");
    return {};
}

Result<void> checkRender(RenderOptions& options, bool outputGiven) {
    if (auto checked = checkShafts(options.shafts); !checked) return checked;
    if (outputGiven && options.output.empty())
        return fail("-o: the picture's name is empty; give one, or leave -o out");
    if (options.output.empty())
        options.output = std::filesystem::path(options.view.scene).stem().string() +
                         (options.view.layer == Layer::Shafts ? ".exr" : ".png");
    if (options.pipelineCache && options.pipelineCache->empty())
        return fail("--pipeline-cache: the file's name is empty; give one, or {}", noPipelineCache);
    const auto format = pictureFormat(options.output);
    if (!format)
        return fail("-o: {} is neither .png nor .exr; give the picture one of these extensions", options.output);
    if (options.view.layer == Layer::Shafts && *format != PictureFormat::Exr)
        return fail("-o: {} cannot hold --layer shafts, which is radiance without limits; write an .exr",
                    options.output);
    options.shafts.displayed = *format == PictureFormat::Png;
    if (options.shafts.exposure && *format == PictureFormat::Exr)
        return fail("--exposure: {} holds radiance as it is, without exposure; leave it out, or write a .png",
                    options.output);
    return {};
}

}  // namespace tyndall::app

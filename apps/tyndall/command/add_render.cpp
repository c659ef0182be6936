#include <kit/image/write_picture.h>

#include <cmath>
#include <filesystem>

#include "../frame/pipeline_cache_file.h"
#include "add_options.h"

namespace tyndall::app {
namespace {

void addShafts(CLI::App& app, ViewOptions& view, ShaftOptions& shafts, SliceCount& slices) {
    addChoice(app, "--layer", view.layer, layerWords, "what to draw");
    addChoice(app, "--method", shafts.plan.method, methodWords, "how shafts are computed");
    addTechnique(app, shafts.plan.terms, "technique for every light, by its name in slices.fx");
    addChoice(app, "--accum", shafts.plan.accumulation, accumulationWords, "where slices are added up");
    addOptional(app, "--planes", slices.planes, "N", "number of equal slices a light, 1 to 65536; as many as needed");
    addOptional(app, "--max-slices", slices.maxSlices, "N",
                "maximum number of slices a light without --planes, 1 to 65536; 256");
    addChoice(app, "--geometry", shafts.plan.geometry, geometryWords, "how slices become triangles");
    addChoice(app, "--look", shafts.plan.look, lookWords, "constants that weigh a slice");
    addOptional(app, "--range", shafts.range, "R",
                "radiance of the value 1 in 8-bit targets; an upper estimate from the lights");
    addShadowSize(app, shafts.plan.shadowMapSize);
    addOptional(app, "--exposure", shafts.exposure, "EV",
                "stops by which a .png is brightened; from the picture's log-average");
    app.add_flag("--force-all", shafts.plan.everything,
                 "leave nothing out, for comparison: every light with every term");
}

void resolveSlices(const SliceCount& asked, PlanOptions& plan) {
    constexpr int articleSlices = 100;
    if (asked.planes) {
        plan.slices = *asked.planes;
        plan.spacing = Spacing::Even;
    } else {
        plan.slices = plan.look == Look::Article ? articleSlices : asked.maxSlices.value_or(defaultMaxSlices);
        plan.spacing = Spacing::Adaptive;
    }
}

}  // namespace

void addRender(CLI::App& app, RenderOptions& options, std::string& size) {
    addViewOptions(app, options.view, size);
    addShafts(app, options.view, options.shafts, options.slices);
    app.add_option("-o,--output", options.output, "picture to write, .png (tone-mapped) or .exr (linear)")
        ->type_name("IMAGE");
    addOptional(app, "--stats", options.stats, "FILE.json", "what was drawn, with times and memory");
    addOptional(app, "--pipeline-cache", options.pipelineCache, "FILE",
                "file that keeps pipelines between runs, or none; in tyndall/ in the user's cache folder");
    app.add_flag("--validate", options.validate, "fail on any message of Vulkan's validation layers");
}

void addExplain(CLI::App& app, ExplainOptions& options, std::string& size) {
    addViewOptions(app, options.view, size);
    addShafts(app, options.view, options.shafts, options.slices);
    app.add_flag("--json", options.json, "as JSON");
}

Result<void> checkShafts(ShaftOptions& shafts, const SliceCount& slices) {
    if (slices.planes && (*slices.planes < 1 || *slices.planes > 65536))
        return fail("--planes: {} is out of bounds; take from 1 to 65536", *slices.planes);
    if (slices.maxSlices && (*slices.maxSlices < 1 || *slices.maxSlices > 65536))
        return fail("--max-slices: {} is out of bounds; take from 1 to 65536", *slices.maxSlices);
    if (shafts.plan.method == Method::Raycast && (slices.planes || slices.maxSlices))
        return fail("{}: has no effect with --method raycast, which has no slices; leave it out",
                    slices.planes ? "--planes" : "--max-slices");
    if (shafts.plan.method == Method::Raycast && shafts.plan.geometry == Geometry::StretchedQuads)
        return fail("--geometry: quads has no effect with --method raycast, which has no slices; leave it out");
    if (slices.maxSlices && (slices.planes || shafts.plan.look == Look::Article))
        return fail("--max-slices: has no effect with {0}; leave {0} out",
                    slices.planes ? "--planes" : "--look article");
    if (slices.planes && shafts.plan.accumulation == Accumulation::Rgba8Routed && *slices.planes % 4 != 0)
        return fail(
            "--planes: {} slices cannot be divided evenly over four channels; with --accum rgba8-routed take a "
            "multiple of 4",
            *slices.planes);
    if (shafts.exposure && !(std::abs(*shafts.exposure) <= 64.0))
        return fail("--exposure: must lie between -64 and 64 stops");
    if (shafts.plan.everything && shafts.plan.terms)
        return fail("--force-all: draws with the full technique; leave --technique out");
    if (auto checked = checkShadowSize(shafts.plan.shadowMapSize); !checked) return checked;
    if (shafts.range && !(*shafts.range > 0.0 && std::isfinite(*shafts.range)))
        return fail("--range: must be a radiance above 0");
    resolveSlices(slices, shafts.plan);
    return {};
}

Result<void> checkRender(RenderOptions& options, bool outputGiven) {
    if (auto checked = checkShafts(options.shafts, options.slices); !checked) return checked;
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

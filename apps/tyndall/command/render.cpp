#include <headless/device.h>
#include <kit/image/files.h>
#include <kit/image/write_picture.h>
#include <tyndall/explain.h>

#include <filesystem>

#include "../frame/pipeline_cache_file.h"
#include "../frame/scene_renderer.h"
#include "check_outputs.h"
#include "commands.h"
#include "json_text.h"
#include "report.h"

namespace tyndall::app {
namespace {

/// An unusable cache file gives only a note later; the path of the scene or an output is an error.
Result<void> checkPipelineCache(const RenderOptions& options) {
    if (!options.pipelineCache || *options.pipelineCache == noPipelineCache) return {};
    const std::string& cache = *options.pipelineCache;
    const auto taken = [&cache](const std::string& by) { return sameFile(cache, by); };
    if (taken(options.view.scene)) return fail("--pipeline-cache: {} is the scene; name another file", cache);
    if (taken(options.output)) return fail("--pipeline-cache: {} is the picture's file; name another one", cache);
    if (options.stats && taken(*options.stats))
        return fail("--pipeline-cache: {} is the file of --stats; name another one", cache);
    return {};
}

}  // namespace

Result<CommandOutput> render(const RenderOptions& options) {
    // Checks come first, because rendering takes seconds.
    if (auto checked = checkOutputs(options.view.scene, options.output, options.stats); !checked)
        return tl::unexpected(checked.error());
    if (auto checked = checkPipelineCache(options); !checked) return tl::unexpected(checked.error());
    auto planned = prepareScene(options.view);
    if (!planned) return tl::unexpected(planned.error());
    auto device = headless::Device::create({.validation = options.validate});
    if (!device) return tl::unexpected(device.error());
    CommandOutput result;
    auto cache = PipelineCacheFile::open(*device, options.pipelineCache, result.notes);
    auto renderer = SceneRenderer::create(*device, planned->scene, cache.handle());
    if (!renderer) return tl::unexpected(renderer.error());
    auto frame = renderer->draw(*planned, options.view, options.shafts, options.stats.has_value());
    if (!frame) return tl::unexpected(frame.error());
    if (options.validate)
        if (const auto messages = device->messages(); !messages.empty())
            return fail("--validate: {} messages, the first: {}", messages.size(), messages.front());

    if (auto written = writePicture(options.output, frame->picture, options.shafts.exposure); !written)
        return tl::unexpected(written.error());
    cache.save(result.notes);
    if (options.stats) {
        auto report = frameReport(*planned, options.view, options.shafts, frame->statistics, device->name());
        report["pipelineCache"] = {
            {"file", cache.path()}, {"bytesLoaded", cache.bytesLoaded()}, {"bytesWritten", cache.bytesWritten()}};
        if (auto written = writeFile(*options.stats, jsonText(report)); !written)
            return tl::unexpected(written.error());
    }
    for (const std::string& warning : planned->scene.warnings) result.notes.push_back("warning: " + warning);
    for (const IgnoredLight& ignored : planned->scene.ignoredLights)
        result.notes.push_back(fmt::format("note: {}: {}", ignored.name, ignored.reason));
    for (const PlannedLight& light : planned->plan.lights)
        if (!light.drawn)
            result.notes.push_back(
                fmt::format("note: light \"{}\": {}", planned->lights[light.light].name, reason(light, planned->view)));
    std::error_code error;
    result.notes.push_back(fmt::format("wrote {}", std::filesystem::absolute(options.output, error).string()));
    return result;
}

}  // namespace tyndall::app

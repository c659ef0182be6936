#include <kit/image/files.h>
#include <kit/image/write_picture.h>
#include <study/reference.h>

#include <algorithm>
#include <filesystem>

#include "../frame/reference_scene.h"
#include "check_outputs.h"
#include "commands.h"
#include "json_text.h"
#include "reference_report.h"

namespace tyndall::app {
namespace {

constexpr const char* interrupted = "interrupted; nothing was written";

double seconds(std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

Result<study::ReferenceScene> sceneFor(const ReferenceOptions& options, const ViewedScene& viewed, ReferenceRun& run) {
    if (options.mode == study::Mode::Ideal) return idealScene(viewed, options.view);
    auto device = headless::Device::create();
    if (!device) return tl::unexpected(device.error());
    run.device = std::string(device->name());
    return hardwareScene(*device, viewed, options.view, options.shadowSize);
}

}  // namespace

Result<CommandOutput> reference(const ReferenceOptions& options, const Progress& progress) {
    if (auto checked = checkOutputs(options.view.scene, options.output, options.stats); !checked)
        return tl::unexpected(checked.error());
    ReferenceRun run;
    auto start = std::chrono::steady_clock::now();
    auto viewed = viewScene(options.view);
    if (!viewed) return tl::unexpected(viewed.error());
    for (std::size_t i = 0; i < viewed->lights.size(); ++i)  // without instances in its volume no shadow map is needed
        viewed->lights[i].shadow = viewed->lights[i].shadow && !viewed->instancesInLight[i].empty();
    if (options.terms)  // if a light lacks a term, the renderer draws with a neutral texture
        for (Light& light : viewed->lights) light = keepOnly(std::move(light), *options.terms);
    const auto scene = sceneFor(options, *viewed, run);
    if (!scene) return tl::unexpected(scene.error());
    if (!progress(0.0)) return fail("{}", interrupted);
    run.preparing = seconds(start);
    run.triangles = scene->triangles.size();

    start = std::chrono::steady_clock::now();
    bool wanted = true;
    const auto image = study::reference(
        *scene, {.accuracy = options.accuracy, .threads = options.threads, .progress = [&](double share) {
                     wanted = wanted && progress(share);
                     return wanted;
                 }});
    if (!wanted) return fail("{}", interrupted);
    if (!image) return passOn(image.error(), options.view.scene);
    run.integrating = seconds(start);

    if (auto written = writePicture(options.output, radianceOf(*image), std::nullopt); !written)
        return tl::unexpected(written.error());
    if (options.stats) {
        const auto report = referenceReport(options, *viewed, *image, run);
        if (auto written = writeFile(*options.stats, jsonText(report)); !written)
            return tl::unexpected(written.error());
    }
    CommandOutput result;
    for (const std::string& warning : viewed->scene.warnings) result.notes.push_back("warning: " + warning);
    for (const IgnoredLight& ignored : viewed->scene.ignoredLights)
        result.notes.push_back(fmt::format("note: {}: {}", ignored.name, ignored.reason));
    if (image->largestBound > options.accuracy) result.notes.push_back(shortfall(options, *image));
    std::error_code error;
    result.notes.push_back(fmt::format("wrote {}: {}", std::filesystem::absolute(options.output, error).string(),
                                       referenceText(*image, run)));
    return result;
}

}  // namespace tyndall::app

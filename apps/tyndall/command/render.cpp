#include <headless/device.h>

#include <filesystem>

#include "../image/write_picture.h"
#include "../render/render_scene.h"
#include "check_outputs.h"
#include "commands.h"
#include "json_text.h"
#include "report.h"

namespace tyndall::app {

Outcome<Said> render(const RenderOptions& options) {
    // What can be known to fail is asked first: rendering takes seconds.
    if (auto checked = checkOutputs(options.view.scene, options.output, options.stats); !checked)
        return tl::unexpected(checked.error());
    auto planned = planScene(options.view, options.shafts);
    if (!planned) return tl::unexpected(planned.error());
    auto device = headless::Device::create({.validation = options.validate});
    if (!device) return fail("{}", device.error().message);
    auto frame = renderScene(*device, *planned, options.view, options.shafts, options.stats.has_value());
    if (!frame) return tl::unexpected(frame.error());
    if (options.validate)
        if (const auto messages = device->messages(); !messages.empty())
            return fail("--validate: {} messages, the first: {}", messages.size(), messages.front());

    if (auto written = writePicture(options.output, frame->picture, options.exposure); !written)
        return tl::unexpected(written.error());
    Said said;
    if (options.stats) {
        const auto report = frameReport(*planned, options.view, options.shafts, frame->statistics, device->name());
        if (auto written = writeText(*options.stats, jsonText(report)); !written)
            return tl::unexpected(written.error());
    }
    for (const std::string& warning : planned->scene.warnings) said.notes.push_back("warning: " + warning);
    for (const IgnoredLight& ignored : planned->scene.ignoredLights)
        said.notes.push_back(fmt::format("note: {}: {}", ignored.name, ignored.reason));
    for (const PlannedLight& light : planned->plan.lights)
        if (!light.drawn)
            said.notes.push_back(
                fmt::format("note: light \"{}\": {}", planned->lights[light.light].name, light.reason));
    std::error_code error;
    said.notes.push_back(fmt::format("wrote {}", std::filesystem::absolute(options.output, error).string()));
    return said;
}

}  // namespace tyndall::app

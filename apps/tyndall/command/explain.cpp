#include <headless/device.h>

#include "../frame/scene_renderer.h"
#include "commands.h"
#include "json_text.h"
#include "report.h"

namespace tyndall::app {
namespace {

/// Plans as render does: with the scene's depth, and the exposure of its surfaces. Both must be drawn; without a
/// device, the plan does not use them.
Result<void> planAsDrawn(PlannedScene& planned, const ExplainOptions& options) {
    auto device = headless::Device::create();
    if (!device) return planWithoutDepth(planned, options.view, options.shafts);
    auto renderer = SceneRenderer::create(*device, planned.scene);
    if (!renderer) return tl::unexpected(renderer.error());
    return renderer->plan(planned, options.view, options.shafts);
}

}  // namespace

Result<CommandOutput> explain(const ExplainOptions& options) {
    auto planned = prepareScene(options.view);
    if (!planned) return tl::unexpected(planned.error());
    if (auto done = planAsDrawn(*planned, options); !done) return tl::unexpected(done.error());
    CommandOutput result;
    result.output = options.json ? jsonText(planReport(*planned, options.view, options.shafts))
                                 : planText(*planned, options.view, options.shafts);
    return result;
}

}  // namespace tyndall::app

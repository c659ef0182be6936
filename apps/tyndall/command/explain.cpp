#include "commands.h"
#include "json_text.h"
#include "report.h"

namespace tyndall::app {

Outcome<Said> explain(const ExplainOptions& options) {
    const auto planned = planScene(options.view, options.shafts);
    if (!planned) return tl::unexpected(planned.error());
    Said said;
    said.output = options.json ? jsonText(planReport(*planned, options.view, options.shafts))
                               : planText(*planned, options.view, options.shafts);
    return said;
}

}  // namespace tyndall::app

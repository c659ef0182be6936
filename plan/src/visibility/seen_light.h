// What the view sees of one light's volume.
#pragma once

#include <tyndall/plan.h>

#include "geometry/inline_vector.h"
#include "plan_context.h"
#include "visibility/light_volume.h"
#include "visibility/seen_air.h"
#include "visibility/walls.h"

namespace tyndall {

struct SeenLight {
    Verdict verdict = Verdict::Drawn;  ///< why nothing of it is seen
    LightPose pose;
    LightVolume volume;
    SeenAir air;
    InlineVector<glm::dvec4, mostWalls> walls;  ///< view space, as wallsOf() gave them
    bool measured = false;                      ///< the volume has depths; without them nothing can be drawn of it

    /// Whether the light may be drawn: it is seen, or everything is drawn and it has a volume.
    bool drawable(const PlanOptions& options) const {
        return verdict == Verdict::Drawn || (options.everything && measured);
    }
};

/// `asked`: which terms the light or the options ask for. Walls end the volume only where shadows are drawn, a cookie's
/// beam bounds it only where the cookie is. `scratch`: working memory.
SeenLight seenLight(const PlanContext& context, const Light& light, const LightSurvey& survey,
                    const PerTerm<TermVerdict>& asked, WallScratch& scratch);

}  // namespace tyndall

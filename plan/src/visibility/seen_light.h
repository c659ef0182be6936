// The part of one light's volume that the view sees.
#pragma once

#include <tyndall/plan.h>

#include "geometry/convex_polyhedron.h"
#include "geometry/inline_vector.h"
#include "plan_context.h"
#include "visibility/light_volume.h"
#include "visibility/seen_air.h"
#include "visibility/walls.h"

namespace tyndall {

struct SeenLight {
    Verdict verdict = Verdict::Drawn;  ///< why nothing of it is seen, or Drawn
    LightPose pose;
    LightVolume volume;
    SeenAir air;
    InlineVector<glm::dvec4, maxWalls> walls;  ///< view space, as wallsOf() gave them
    bool measured = false;                     ///< the volume has depths, which drawing needs

    /// Whether the light may be drawn: it is seen, or everything is drawn and it has a volume.
    bool drawable(const PlanOptions& options) const {
        return verdict == Verdict::Drawn || (options.everything && measured);
    }
};

/// `asked`: which terms the light or the options ask for. Walls end the volume only if shadows are drawn; a cookie's
/// beam bounds it only if the cookie is drawn. `lit` becomes the lit part of the volume that the view's frustum shows,
/// if the verdict is Drawn. `scratch`: working memory.
SeenLight seenLight(const PlanContext& context, const Light& light, const LightSurvey& survey,
                    const PerTerm<TermVerdict>& asked, ConvexPolyhedron& lit, WallScratch& scratch);

}  // namespace tyndall

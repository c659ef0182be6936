// The stages of plan(), each a function over plain data: consider() finds what a light shows and needs,
// leaveOutTheFaint() drops what is too faint, the rest becomes geometry. plan.cpp runs them.
#pragma once

#include <tyndall/plan.h>

#include <vector>

#include "geometry/convex_polyhedron.h"
#include "needs/needed_terms.h"
#include "plan_context.h"
#include "slabs/slabs.h"
#include "slice_constants.h"
#include "visibility/light_volume.h"
#include "visibility/seen_air.h"
#include "visibility/walls.h"

namespace tyndall {

/// A light that may be drawn: it has strength, and the picture shows its volume.
struct Candidate {
    std::uint32_t light = 0;
    SeenLight seen;
    NeededTerms needed;
    Slabs slabs;
    double base = 0.0;                           ///< brightestWithoutTerms()
    double shadowBias = 0.0;                     ///< metres along the light's axis
    std::uint32_t firstCorner = 0, corners = 0;  ///< into ConsiderScratch::outlines; Method::Raycast only
};

/// Working memory of consider() and surfaceLight().
struct ConsiderScratch {
    WallScratch walls;
    ConvexPolyhedron lit;
    std::vector<glm::dvec2> outlines;  ///< clip coordinates
    std::vector<OccluderShadow> shadows;
};

/// Fills `planned`, and `candidate` if it returns true. False: the verdict gives the reason why the light is not drawn.
bool consider(const PlanContext& context, const Light& light, const LightSurvey& survey, PlannedLight& planned,
              Candidate& candidate, ConsiderScratch& scratch);

/// The needs of the light's surfaces; see Planner::surfaces().
void surfaceLight(const PlanContext& context, const Light& light, SurfaceLight& needed, ConsiderScratch& scratch);

/// One thing that may be left out, and the maximum change from that.
struct Omission {
    double error;  ///< radiance
    std::uint32_t candidate;
    std::optional<Term> term;  ///< absent: the whole light
};

/// Leaves out lights (TooFaint) and terms (Invisible), the faintest first, as long as all omissions together stay under
/// a quarter of a display step.
void leaveOutTheFaint(const PlanOptions& options, std::span<Candidate> candidates, std::span<PlannedLight> lights,
                      std::vector<Omission>& scratch);

}  // namespace tyndall

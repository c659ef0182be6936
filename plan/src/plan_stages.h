// The stages of plan(), each a function over plain data: consider() what a light can show and needs, leave out what is
// too faint, draw the rest. plan.cpp runs them.
#pragma once

#include <tyndall/plan.h>

#include <vector>

#include "visibility/light_volume.h"
#include "needs/needed_terms.h"
#include "plan_context.h"
#include "visibility/seen_air.h"
#include "slabs/slabs.h"
#include "slice_constants.h"
#include "visibility/walls.h"

namespace tyndall {

/// A light that its strength and its place in the picture do not rule out.
struct Candidate {
    std::uint32_t light = 0;
    SeenLight seen;
    NeededTerms needed;
    Slabs slabs;
    double base = 0.0;        ///< brightestWithoutTerms()
    double shadowBias = 0.0;  ///< metres along the light's axis
};

/// Working memory of consider() and surfaceLight().
struct ConsiderScratch {
    WallScratch walls;
    std::vector<OccluderShadow> shades;
};

/// Fills `planned`, and `candidate` where it returns true. False: the verdict says why the light is not drawn.
bool consider(const PlanContext& context, const Light& light, const LightSurvey& survey, PlannedLight& planned,
              Candidate& candidate, ConsiderScratch& scratch);

/// What surfaces need of a light; see Planner::surfaces().
void surfaceLight(const PlanContext& context, const Light& light, SurfaceLight& needed, ConsiderScratch& scratch);

/// One thing that may be left out, and what that changes at most.
struct Omission {
    double error;  ///< radiance
    std::uint32_t candidate;
    std::optional<Term> term;  ///< absent: the whole light
};

/// Leaves out what together stays under a quarter of a display step, the faintest first: lights become TooFaint, terms
/// Invisible.
void leaveOutTheFaint(const PlanOptions& options, std::span<Candidate> candidates, std::span<PlannedLight> lights,
                      std::vector<Omission>& scratch);

}  // namespace tyndall

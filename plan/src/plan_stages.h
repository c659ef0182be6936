// The stages of plan(), each a function over plain data: consider() what a light can show and needs, leave out what is
// too faint, draw the rest. plan.cpp runs them.
#pragma once

#include <tyndall/plan.h>

#include <vector>

#include "visibility/light_volume.h"
#include "needs/needs.h"
#include "needs/plan_technique.h"
#include "visibility/seen_air.h"
#include "slabs/slabs.h"
#include "visibility/walls.h"

namespace tyndall {

/// A light that its strength and its place in the picture do not rule out.
struct Candidate {
    std::uint32_t light = 0;
    LightPose pose;
    LightVolume volume;
    SeenAir air;
    Slabs slabs;
    ShadowNeed shadow;
    double base = 0.0;             ///< brightestWithoutTerms()
    FactorRange cookie, noise;     ///< over what is seen
    glm::dvec3 cookieFactor{1.0};  ///< stands in for a cookie that is not drawn
    double noiseFactor = 1.0;
    double shadowBias = 0.0;  ///< metres along the light's axis
    bool divisible = false;   ///< into what `shadow` says may lie in shadow and the rest
};

/// What stays the same for all lights of one plan.
struct PlanContext {
    const View& view;
    const PlanOptions& options;
    const Surroundings& surroundings;
    std::span<const OccluderBounds> occluders;
    std::span<const BlockerBounds> blockers;
    InlineVector<glm::dvec4, 4> sides;  ///< of the view
    std::optional<Terms> technique;     ///< that the options ask for
};

/// Working memory of consider().
struct ConsiderScratch {
    WallScratch walls;
    std::vector<OccluderShadow> shades;
};

/// Fills `planned`, and `candidate` where it returns true. False: the verdict says why the light is not drawn.
bool consider(const PlanContext& context, const Light& light, const LightSurvey& survey, PlannedLight& planned,
              Candidate& candidate, ConsiderScratch& scratch);

/// One thing that may be left out, and what that changes at most.
struct Omission {
    double error;  ///< radiance
    std::uint32_t candidate;
    enum class Kind : std::uint8_t { Light, Noise, Cookie } kind;
};

/// Leaves out what together stays under a quarter of a display step, the faintest first: lights become TooFaint, terms
/// Invisible.
void leaveOutTheFaint(const PlanOptions& options, std::span<Candidate> candidates, std::span<PlannedLight> lights,
                      std::vector<Omission>& scratch);

}  // namespace tyndall

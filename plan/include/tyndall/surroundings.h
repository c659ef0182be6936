// What plan() may know of the scene around the lights, to leave out what cannot be seen. Omitted information is treated
// conservatively: the light is drawn, with all of its terms. An empty Surroundings leaves out only what the lights and
// the view alone show to be invisible.
#pragma once

#include <tyndall/blocker_set.h>
#include <tyndall/depth_survey.h>
#include <tyndall/occluder_set.h>
#include <tyndall/texture_survey.h>

#include <optional>
#include <span>

namespace tyndall {

/// Surveys of a light's textures. Null without a survey: the texture may then hold any value anywhere.
struct LightSurvey {
    const TextureSurvey* cookie = nullptr;
    const TextureSurvey* noise = nullptr;
};

/// Everything pointed at must stay alive while plan() runs. plan() does not check the sets again: their factories did.
struct Surroundings {
    const OccluderSet* occluders = nullptr;  ///< all occluders of the scene; null: they may be anywhere
    const BlockerSet* blockers = nullptr;    ///< null: no light's volume ends at a wall
    std::optional<DepthTiles> depth;         ///< absent: no surface hides anything
    std::span<const LightSurvey> surveys;    ///< one for each light, in their order; or none
};

}  // namespace tyndall

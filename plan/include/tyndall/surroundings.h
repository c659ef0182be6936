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

/// Surveys of a light's textures. Null where none was made: the texture may hold any value anywhere.
struct LightSurvey {
    const TextureSurvey* cookie = nullptr;
    const TextureSurvey* noise = nullptr;
};

/// The caller keeps alive what is pointed at while planning. plan() takes sets as they are: their factories have
/// checked and bounded them.
struct Surroundings {
    const OccluderSet* occluders = nullptr;  ///< all there are; null: they may be anywhere
    const BlockerSet* blockers = nullptr;    ///< null: no light's volume ends at a wall
    std::optional<DepthTiles> depth;         ///< absent: no surface hides anything
    std::span<const LightSurvey> surveys;    ///< one for each light, in their order; or none
};

}  // namespace tyndall

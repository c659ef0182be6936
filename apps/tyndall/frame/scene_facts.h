// What a plan may know of a scene, read off it once.
#pragma once

#include <tyndall/surroundings.h>

#include <optional>
#include <vector>

#include "../scene/scene.h"
#include "occluder_boxes.h"

namespace tyndall::app {

struct SceneFacts {
    OccluderBoxes occluders;
    std::vector<Blocker> blockers;
    std::vector<std::optional<TextureSurvey>> cookies, noises;  ///< by Scene::images, of those that lights use as such
    std::vector<LightSurvey> surveys;                           ///< by Scene::lights, into these
};

SceneFacts surveyScene(const Scene& scene);

/// Brings the facts up to date where instances have moved since.
void followInstances(SceneFacts& facts, const Scene& scene);

/// The facts as plan() takes them, which must not outlive `facts`.
Surroundings surroundingsOf(const SceneFacts& facts);

}  // namespace tyndall::app

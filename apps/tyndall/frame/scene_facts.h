// The library's surveys of a scene, for a plan.
#pragma once

#include <tyndall/result.h>
#include <tyndall/surroundings.h>

#include <optional>
#include <vector>

#include "../scene/scene.h"

namespace tyndall::app {

struct SceneFacts {
    OccluderSet occluders;
    BlockerSet blockers;
    std::vector<std::optional<TextureSurvey>> cookies, noises;  ///< by Scene::images, for the images that lights use
    std::vector<LightSurvey> surveys;                           ///< by Scene::lights, pointing into these
};

Result<SceneFacts> surveyScene(const Scene& scene);

/// Updates the facts if instances have moved.
Result<void> followInstances(SceneFacts& facts, const Scene& scene);

/// The facts in plan()'s form; the result must not outlive `facts`.
Surroundings surroundingsOf(const SceneFacts& facts);

}  // namespace tyndall::app

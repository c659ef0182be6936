// What a plan may know of a scene: the library's surveys of it.
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
    std::vector<std::optional<TextureSurvey>> cookies, noises;  ///< by Scene::images, of those that lights use as such
    std::vector<LightSurvey> surveys;                           ///< by Scene::lights, into these
};

Result<SceneFacts> surveyScene(const Scene& scene);

/// Brings the facts up to date where instances have moved since.
Result<void> followInstances(SceneFacts& facts, const Scene& scene);

/// The facts as plan() takes them, which must not outlive `facts`.
Surroundings surroundingsOf(const SceneFacts& facts);

}  // namespace tyndall::app

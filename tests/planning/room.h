// A recipe's scene as input for planner and renderer, with depths by ray casting.
#pragma once

#include <tyndall/plan.h>

#include <array>
#include <vector>

#include "recipe.h"
#include "texture.h"

namespace tyndall::test {

using Triangle = std::array<glm::dvec3, 3>;

struct Room {
    static constexpr int width = 64, height = 36;
    static constexpr std::uint32_t shadowMapSize = 512;

    std::vector<Light> lights;
    std::vector<Texture> slides, dust;  ///< one for each light; empty where it has none
    OccluderSet occluders;
    BlockerSet blockers;
    std::vector<Triangle> triangles;  ///< of all surfaces
    View view;
    Texture depth;  ///< stored, at pixel centres
    std::vector<float> tiles;
    int columns = 1, rows = 1;
    PlanOptions options;

    std::vector<TextureSurvey> surveys;  ///< cookie and noise of each light
    std::vector<LightSurvey> lightSurveys;

    Room() = default;
    Room(const Room&) = delete;  // others hold pointers to its surveys
    Room& operator=(const Room&) = delete;

    /// Complete surroundings.
    Surroundings surroundings() const;
};

void build(const Recipe& recipe, Room& room);

}  // namespace tyndall::test

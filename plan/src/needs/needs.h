// Which of a light's terms the view needs.
#pragma once

#include <tyndall/plan.h>
#include <tyndall/surroundings.h>

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "geometry/inline_vector.h"
#include "visibility/seen_air.h"

namespace tyndall {

/// The air of a light that may lie in shadow: none before `firstOccluder`; from there to `firstLarge` only air within
/// the slopes; all air behind that.
struct ShadowNeed {
    bool needed = false;
    double firstOccluder = 0.0, firstLarge = 0.0;  ///< metres along the light's axis, at least its near plane
    SlopeRange slopes;
};

/// The air that one occluder may shade.
struct OccluderShadow {
    double axis;  ///< metres along the light's axis to its beginning
    SlopeRange slopes;
};

/// Whether an occluder can stand between the lamp and the seen air: whether its box, or its triangles if given, meet
/// the space between both. Occluders behind a wall (planes of view space, see walls.h) do not count. `mapSize`: texels
/// a side of the shadow map, whose filtering reads one texel farther out. `scratch`: working memory.
ShadowNeed shadowNeed(const Light& light, const LightPose& pose, const SeenAir& air, std::span<const glm::dvec4> walls,
                      const OccluderSet& occluders, std::uint32_t mapSize, std::vector<OccluderShadow>& scratch);

/// The factors by which a texture can multiply a light.
struct FactorRange {
    glm::dvec3 min{1.0}, max{1.0};
    glm::dvec3 middle() const { return 0.5 * (min + max); }
    /// Largest magnitude, of any channel: a caller's float texture may hold negative values.
    double largest() const;
    /// Half the largest difference, of any channel.
    double spread() const;
};

/// The cookie's factors in the air that is seen; 0 to infinity without a survey. 1 for a light without a cookie.
FactorRange cookieRange(const Light& light, const SeenAir& air, const TextureSurvey* survey);

/// The factors gain * red * green; 0 to infinity without a survey. 1 for a light without noise.
FactorRange noiseRange(const Light& light, const TextureSurvey* survey);

}  // namespace tyndall

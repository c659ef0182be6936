// Which of a light's terms the view calls for.
#pragma once

#include <tyndall/plan.h>
#include <tyndall/surroundings.h>

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "geometry/inline_vector.h"
#include "visibility/seen_air.h"

namespace tyndall {

/// An occluder's box with a sphere around it; the same for every light.
struct OccluderBounds {
    OccluderBox box;
    glm::dvec3 centre{0.0};  ///< world space
    double radius = 0.0;     ///< metres
};

OccluderBounds boundsOf(const OccluderBox& box);

/// Which of a light's air may lie in shadow: nothing before `firstOccluder`; from there to `firstLarge` only what lies
/// within the rectangle of slopes; behind that anything.
struct ShadowNeed {
    bool needed = false;
    double firstOccluder = 0.0, firstLarge = 0.0;  ///< metres along the light's axis, at least its near plane
    glm::dvec2 shadeMin{0.0}, shadeMax{0.0};       ///< light-space x / w and y / w
};

/// What one occluder may keep from the light.
struct Shade {
    double axis;  ///< metres along the light's axis, where it begins
    glm::dvec2 least, most;
};

/// Whether an occluder can stand between the lamp and the air that is seen: whether its box meets what the lamp has
/// to shine through to get there. What lies behind a wall (planes of view space, see walls.h) does not count.
/// `mapSize`: texels a side of the shadow map, whose filtering reads a texel farther out. `scratch`: working memory.
ShadowNeed shadowNeed(const Light& light, const LightPose& pose, const SeenAir& air, std::span<const glm::dvec4> walls,
                      std::span<const OccluderBounds> occluders, std::uint32_t mapSize, std::vector<Shade>& scratch);

/// What a texture can multiply a light by.
struct FactorRange {
    glm::dvec3 least{1.0}, most{1.0};
    glm::dvec3 middle() const { return 0.5 * (least + most); }
    /// Largest magnitude, of any channel: a caller's float texture may hold negative values.
    double largest() const;
    /// Half the largest difference, of any channel.
    double spread() const;
};

/// Of the cookie over what is seen of it; from 0 to infinity where there is no survey. 1 for a light without.
FactorRange cookieRange(const Light& light, const SeenAir& air, const TextureSurvey* survey);

/// Of gain * red * green. 0 to infinity without a survey. 1 for a light without noise.
FactorRange noiseRange(const Light& light, const TextureSurvey* survey);

}  // namespace tyndall

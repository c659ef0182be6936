// What plan() may know of the scene around the lights, to leave out what cannot be seen. Whatever is not told is
// taken to be needed, so an empty Surroundings plans as if everything were.
#pragma once

#include <tyndall/texture_survey.h>

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace tyndall {

/// A box around something that throws shadows. Flat ones are fine.
struct OccluderBox {
    glm::dmat4 worldFromBox{1.0};  ///< affine: may scale and shear
    glm::dvec3 minimum{0.0}, maximum{0.0};
    /// What is in it, in the box's space, where the caller has that at hand: looked at one by one where a light meets
    /// the box. Kept alive by the caller while planning.
    std::span<const std::array<glm::vec3, 3>> triangles = {};
};

/// Triangles of one plane, of things in the shadow map that are seen, too, in metres of world space: a floor, a
/// wall. Where blockers together cover all of a light's pyramid, no light gets past them and none is simulated.
struct Blocker {
    std::vector<std::array<glm::dvec3, 3>> triangles;  ///< within half a millimetre of one plane, either winding
};

/// The scene's depth as drawn for this very view, tile by tile.
struct DepthTiles {
    std::uint32_t columns = 0, rows = 0;  ///< of equal tiles over the picture; row 0 at its top
    std::span<const float> farthest;      ///< metres of view depth, of every pixel that the tile overlaps; infinite
                                          ///< where one shows no surface
};

/// Surveys of a light's textures; null where none was made. The caller keeps them alive while planning.
struct LightSurvey {
    const TextureSurvey* cookie = nullptr;
    const TextureSurvey* noise = nullptr;
};

struct Surroundings {
    std::optional<std::span<const OccluderBox>> occluders;  ///< all there are; absent: they may be anywhere
    std::span<const Blocker> blockers;                      ///< those that are worth a look: large ones
    std::optional<DepthTiles> depth;
    std::span<const LightSurvey> surveys;  ///< one for each light, in their order; or none
};

}  // namespace tyndall

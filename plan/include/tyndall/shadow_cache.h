// Which shadow maps must be drawn again, and which occluders a map needs. Pure CPU work, no Vulkan device.
//
//   for each light that throws shadows:
//       collect the occluders that mayShade() it, and what shadowCaster() makes of each
//       if (cache.stale(light, lights[light], casters, size)) {
//           renderer.recordShadowMap(commands, frame, lights[light], occluders, maps[light], format, size);
//           cache.drawn(light, lights[light], casters, size);
//       }
//
// Moving and static occluders are treated alike: a map is stale once anything that it shows has moved. Not thread-safe.
#pragma once

#include <tyndall/light.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace tyndall {

/// A box in mesh space, metres, that holds all vertices of an occluder.
struct MeshBounds {
    glm::dvec3 minimum{0.0}, maximum{0.0};
};

/// One thing in a shadow map: where it stands, and numbers of the caller's choice that identify its triangles.
/// shadowCaster() in renderer.h makes one from an Occluder.
struct ShadowCaster {
    glm::dmat4 worldFromMesh{1.0};
    std::array<std::uint64_t, 6> geometry{};  ///< all 0: it has no triangles and does not count
};

/// False only if no vertex in `bounds` can change the light's shadow map: the whole box lies beyond one of the six
/// planes of the light's pyramid, by more than the rounding of the draw. Such an occluder may be left out of
/// recordShadowMap(); its moves then do not make the map stale. True if a value is not finite.
bool mayShade(const Light& light, const glm::dmat4& worldFromMesh, const MeshBounds& bounds);

/// Remembers what each light's shadow map was drawn from: 16 bytes a light.
class ShadowCache {
public:
    /// Whether the map of `light`, a number of the caller's choice from 0 on, would look different now: true until
    /// drawn(), then true once the light's pose, field of view, near or far plane, the map's size, or any caster's
    /// worldFromMesh or geometry has changed. The order of the casters, casters without triangles, the sign of a zero
    /// and all other fields of Light are ignored. Does not allocate.
    ///
    /// Values are compared by a hash of 128 bits: one change in 2^128 is missed. Triangles themselves are not read: if
    /// they change and their numbers do not, call invalidate().
    bool stale(std::size_t light, const Light& source, std::span<const ShadowCaster> casters, std::uint32_t size) const;

    /// The map of `light` now shows this. Allocates if `light` is higher than any before.
    void drawn(std::size_t light, const Light& source, std::span<const ShadowCaster> casters, std::uint32_t size);

    /// The map of `light` is lost, or shows something else: stale until drawn again.
    void invalidate(std::size_t light);
    /// All maps are lost.
    void invalidate();

private:
    struct Shown {
        std::uint64_t low = 0, high = 0;
        bool operator==(const Shown&) const = default;
    };
    static Shown shownBy(const Light& source, std::span<const ShadowCaster> casters, std::uint32_t size);
    std::vector<Shown> lights_;  ///< zero: nothing is known of the map
};

}  // namespace tyndall

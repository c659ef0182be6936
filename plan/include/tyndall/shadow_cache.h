// Which shadow maps must be drawn again, and which occluders a map needs. Pure CPU work, no Vulkan device.
//
//   for each light that throws shadows:
//       collect the occluders that mayShade() it, and what shadowCaster() makes of each
//       if (cache.stale(light, lights[light], casters, size)) {
//           renderer.recordShadowMap(commands, frame, lights[light], occluders, maps[light], format, size);
//           cache.drawn(light, lights[light], casters, size);
//       }
//
// Nothing here tells a moving shadow from a static one: a map goes stale when what it shows has moved. Not
// thread-safe.
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

/// One thing in a shadow map: where it stands, and numbers of the caller's choice that tell its triangles from all
/// others. renderer.h makes one of an Occluder: shadowCaster().
struct ShadowCaster {
    glm::dmat4 worldFromMesh{1.0};
    std::array<std::uint64_t, 6> geometry{};  ///< all 0: it has no triangles and does not count
};

/// False only where no vertex in `bounds` can leave a mark in the light's shadow map: the whole box lies beyond one
/// of the six planes of the light's pyramid, by more than the rounding of what draws it. Such an occluder may be left
/// out of recordShadowMap(), and then does not make the map stale when it moves. True wherever a value is not finite.
bool mayShade(const Light& light, const glm::dmat4& worldFromMesh, const MeshBounds& bounds);

/// Remembers what each light's shadow map was drawn from: 16 bytes a light.
class ShadowCache {
public:
    /// Whether the map of `light`, a number of the caller's choice from 0 on, would look different now: true until
    /// drawn(), then where the light's pose, field of view, near or far plane, the map's size, or any caster's
    /// worldFromMesh or geometry is another one. The order of the casters does not count, nor do those without
    /// triangles, the sign of a zero, and what else a Light says. Does not allocate.
    ///
    /// Values are told apart by 128 bits of hash: by chance one change in 2^128 is missed. Triangles are not
    /// looked at: where they change and their numbers do not, invalidate().
    bool stale(std::size_t light, const Light& source, std::span<const ShadowCaster> casters, std::uint32_t size) const;

    /// The map of `light` now shows this. Allocates where `light` is higher than any before.
    void drawn(std::size_t light, const Light& source, std::span<const ShadowCaster> casters, std::uint32_t size);

    /// The map of `light` is lost, or shows something else: stale until drawn again.
    void invalidate(std::size_t light);
    /// All maps are.
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

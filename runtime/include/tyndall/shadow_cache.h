// Which shadow maps must be drawn again, and which occluders a map needs. Pure CPU work, no Vulkan device.
//
//   for each light that throws shadows:
//       collect the occluders that mayShade() it
//       if (cache.stale(light, lights[light], occluders, size)) {
//           renderer.recordShadowMap(commands, frame, lights[light], occluders, maps[light], format, size);
//           cache.drawn(light, lights[light], occluders, size);
//       }
//
// Nothing here tells a moving shadow from a static one: a map goes stale when what it shows has moved. Not
// thread-safe.
#pragma once

#include <tyndall/light.h>
#include <tyndall/renderer.h>

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

/// False only where no vertex in `bounds` can leave a mark in the light's shadow map: the whole box lies beyond one
/// of the six planes of the light's pyramid, by more than the rounding of what draws it. Such an occluder may be left
/// out of recordShadowMap(), and then does not make the map stale when it moves. True wherever a value is not finite.
bool mayShade(const Light& light, const Occluder& occluder, const MeshBounds& bounds);

/// Remembers what each light's shadow map was drawn from: 16 bytes a light.
class ShadowCache {
public:
    /// Whether the map of `light`, a number of the caller's choice from 0 on, would look different now: true until
    /// drawn(), then where the light's pose, field of view, near or far plane, the map's size, or any occluder's
    /// worldFromMesh, buffers or place in them is another one. Neither the order of the occluders counts, nor those
    /// without indices, nor the sign of a zero, nor what else a Light says. Does not allocate.
    ///
    /// Values are told apart by 128 bits of hash: by chance one change in 2^128 is missed. Contents of buffers are not
    /// looked at: where they change, or where another buffer may have got the handle of one that was destroyed,
    /// invalidate().
    bool stale(std::size_t light, const Light& source, std::span<const Occluder> occluders, std::uint32_t size) const;

    /// The map of `light` now shows this. Allocates where `light` is higher than any before.
    void drawn(std::size_t light, const Light& source, std::span<const Occluder> occluders, std::uint32_t size);

    /// The map of `light` is lost, or shows something else: stale until drawn again.
    void invalidate(std::size_t light);
    /// All maps are.
    void invalidate();

private:
    struct Shown {
        std::uint64_t low = 0, high = 0;
        bool operator==(const Shown&) const = default;
    };
    static Shown shownBy(const Light& source, std::span<const Occluder> occluders, std::uint32_t size);
    std::vector<Shown> lights_;  ///< zero: nothing is known of the map
};

}  // namespace tyndall

#include <tyndall/shadow_cache.h>

#include <bit>
#include <cmath>
#include <limits>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace tyndall {
namespace {

/// Values one after the other without padding, in memory of their own so that nothing is allocated.
template <std::size_t Capacity>
class Canonical {
public:
    void add(std::uint64_t value) { words_[count_++] = value; }
    /// Both zeros draw the same, and so do all NaNs: nothing.
    void add(double value) {
        if (std::isnan(value)) value = std::numeric_limits<double>::quiet_NaN();
        add(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value));
    }
    void add(const glm::dmat4& matrix) {
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) add(matrix[column][row]);
    }
    XXH128_hash_t hash() const { return XXH3_128bits(words_.data(), count_ * sizeof(std::uint64_t)); }

private:
    std::array<std::uint64_t, Capacity> words_;
    std::size_t count_ = 0;
};

}  // namespace

bool mayShade(const Light& light, const glm::dmat4& worldFromMesh, const MeshBounds& bounds) {
    const glm::dmat4 clipFromMesh = lightClipFromWorld(light) * worldFromMesh;
    // What draws the map rounds this matrix and the products with it to floats: some 6 times 2^-24 of the terms' sum.
    constexpr double rounding = 1e-6;
    std::array<int, 6> beyond{};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 point(corner & 1 ? bounds.maximum.x : bounds.minimum.x,
                               corner & 2 ? bounds.maximum.y : bounds.minimum.y,
                               corner & 4 ? bounds.maximum.z : bounds.minimum.z, 1.0);
        glm::dvec4 clip(0.0), terms(0.0);
        for (int i = 0; i < 4; ++i) {
            clip += clipFromMesh[i] * point[i];
            terms += glm::abs(clipFromMesh[i] * point[i]);
        }
        // Vulkan's clip volume: -w <= x <= w, -w <= y <= w, 0 <= z <= w. Each is linear in the point, so a box is
        // beyond one of them where its corners are.
        for (int axis = 0; axis < 3; ++axis) {
            const double margin = rounding * (terms[axis] + terms[3]);
            const double lowest = axis == 2 ? 0.0 : -clip.w;
            if (clip[axis] - lowest < -margin) ++beyond[static_cast<std::size_t>(2 * axis)];
            if (clip.w - clip[axis] < -margin) ++beyond[static_cast<std::size_t>(2 * axis + 1)];
        }
    }
    for (const int corners : beyond)
        if (corners == 8) return false;
    return true;
}

ShadowCache::Shown ShadowCache::shownBy(const Light& source, std::span<const ShadowCaster> casters,
                                        std::uint32_t size) {
    Canonical<24> lamp;
    lamp.add(source.worldFromLight);
    for (const double value : {source.fov.x, source.fov.y, source.nearPlane, source.farPlane}) lamp.add(value);
    lamp.add(std::uint64_t{size});
    // A sum, so that order does not count; unlike an exclusive or it does not cancel an occluder that comes twice.
    XXH128_hash_t sum{};
    for (const ShadowCaster& caster : casters) {
        if (caster.geometry == decltype(caster.geometry){}) continue;
        Canonical<24> one;
        one.add(caster.worldFromMesh);
        for (const std::uint64_t number : caster.geometry) one.add(number);
        const XXH128_hash_t hash = one.hash();
        sum.low64 += hash.low64;
        sum.high64 += hash.high64;
    }
    lamp.add(sum.low64);
    lamp.add(sum.high64);
    const XXH128_hash_t shown = lamp.hash();
    // Zero stands for a map of which nothing is known.
    return shown.low64 || shown.high64 ? Shown{shown.low64, shown.high64} : Shown{1, 0};
}

bool ShadowCache::stale(std::size_t light, const Light& source, std::span<const ShadowCaster> casters,
                        std::uint32_t size) const {
    if (light >= lights_.size() || lights_[light] == Shown{}) return true;
    return lights_[light] != shownBy(source, casters, size);
}

void ShadowCache::drawn(std::size_t light, const Light& source, std::span<const ShadowCaster> casters,
                        std::uint32_t size) {
    if (light >= lights_.size()) lights_.resize(light + 1);
    lights_[light] = shownBy(source, casters, size);
}

void ShadowCache::invalidate(std::size_t light) {
    if (light < lights_.size()) lights_[light] = {};
}

void ShadowCache::invalidate() {
    lights_.clear();
}

}  // namespace tyndall

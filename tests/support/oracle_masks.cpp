#include "oracle_masks.h"

#include <stdexcept>

#include "oracle_fragment.h"
#include "oracle_volume.h"

namespace tyndall::test {
namespace {

Interval maskOf(const Masks& masks, Term term, int channel) {
    switch (term) {
        case Term::Noise:
            return masks.noise;
        case Term::Shadow:
            return masks.shadow;
        case Term::Cookie:
            return masks.cookie[channel];
        case Term::Scattering:
            return masks.scattering;
    }
    throw std::logic_error("no such term");
}

/// A shadow's edge may be lit or not, so quotients of pictures are undefined there.
bool wellKnown(const std::array<Interval, 4>& rest) {
    for (int c = 0; c < 3; ++c)
        if (!(rest[c].lo > 0.0 && rest[c].hi < 1.01 * rest[c].lo)) return false;
    return true;
}

}  // namespace

Shot without(Shot shot, Term term) {
    if (term == Term::Noise) shot.light.noise.reset();
    if (term == Term::Shadow) shot.light.shadow = false;
    if (term == Term::Cookie) shot.light.cookie = false;
    if (term == Term::Scattering) {
        shot.light.anisotropy = 0.0;
        shot.light.albedo.reset();
    }
    return shot;
}

std::vector<std::optional<std::array<Interval, 3>>> projectedMask(const Shot& shot, Term term) {
    if (shot.slices != 1) throw std::logic_error("a mask is projected onto one slice");
    const Shot plain = without(shot, term);
    const auto volume = lightVolume(shot.light, glm::inverse(shot.eye.worldFromView));
    const auto points = corners(volume);
    const Range range = depthRange(points, shot.eye.nearPlane, std::min(shot.eye.farPlane, shot.farthestSurface));
    const double depth = 0.5 * (range.nearest + range.farthest);
    const FragmentContext masked = fragmentContext(shot, volume, points, range.farthest - range.nearest);
    const FragmentContext open = fragmentContext(plain, volume, points, range.farthest - range.nearest);

    std::vector<std::optional<std::array<Interval, 3>>> quotients;
    for (int y = 0; y < shot.height; ++y)
        for (int x = 0; x < shot.width; ++x) {
            quotients.emplace_back();
            if (coverage(masked, x, y, depth) != Seen::Yes) continue;
            const Masks here = masks(masked, x, y, depth);
            const auto rest = radiance(open, x, y, depth);
            if (!wellKnown(rest)) continue;
            quotients.back().emplace();
            for (int c = 0; c < 3; ++c) {
                const Interval mask = maskOf(here, term, c);
                // At most two multiplications bring the mask into the product.
                (*quotients.back())[c] =
                    rounded({mask.lo * (rest[c].lo / rest[c].hi), mask.hi * (rest[c].hi / rest[c].lo)}, 2.0);
            }
        }
    return quotients;
}

}  // namespace tyndall::test

#include "slabs/slabs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "visibility/pixel_size.h"

namespace tyndall {
namespace {

// The midpoint rule over 1/d^2 is worst for an eye that looks along the beam, where it falls short by growth^2 / 4: by
// a hundredth. For rays that pass the lamp at d it is off by coth(pi d / h) - 1, by 1e-13.
constexpr double mostGrowth = 0.2;
// Slabs to a feature of a cookie or a shadow map, seen at 45 degrees: two samples of each.
constexpr double slabsPerDetail = 2.0;
// Slabs to the beam's width, as far as one sees into it from the side. A pixel counts the slices within the beam, one
// more or one less than it ought to: with two to the width, stripes wind about it like a barber's pole; with eight they
// are gone from the picture, and nothing steps as the eye moves (tests/apps/continuity_test.cpp).
constexpr double slabsPerBeam = 8.0;
// Pixels that neighbouring slices lie apart where a beam is wide: seen at 45 degrees, an edge then steps by so many.
constexpr double leastPixels = 1.0;
// Pixels that a beam is wide where it counts as a line, whose parts nobody can tell from each other.
constexpr double thinBeam = 2.0;
// As many as the budget may be at most.
constexpr double mostBehindWalls = 65535.0;

// 1 / cos of the least angle between the view's axis, forwards or backwards, and a ray of the lamp.
double reach(double cosine, double half) {
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) - half;
    // Beyond 89 degrees the pyramid has next to nothing on that side.
    return 1.0 / std::cos(std::clamp(angle, 0.0, 1.553));
}

double halfDiagonal(const Light& light) {
    return std::atan(glm::length(glm::tan(0.5 * light.fov)));
}

double reachAt(const Slabs& slabs, double offset) {
    return offset > 0.0 ? slabs.reachBehind : slabs.reachBefore;
}

// The beam's lesser width over its distance from the lamp.
double narrowness(const Light& light) {
    return 2.0 * std::tan(0.5 * std::min(light.fov.x, light.fov.y));
}

// Slabs between the lamp's depth and `depth`, negative before the lamp.
double counted(const Slabs& slabs, double depth) {
    const double offset = depth - slabs.lampDepth;
    const double steepness = slabs.growth * reachAt(slabs, offset);
    return std::asinh(steepness * offset / slabs.least) / (steepness * slabs.scale);
}

double depthAt(const Slabs& slabs, double count) {
    const double steepness = slabs.growth * reachAt(slabs, count);
    return slabs.lampDepth + slabs.least * std::sinh(count * steepness * slabs.scale) / steepness;
}

}  // namespace

Slabs slabsOf(const Light& light, const View& view, const PlanOptions& options, const LightPose& pose,
              const LightVolume& volume, double detail, double visible) {
    Slabs slabs;
    slabs.nearDepth = volume.nearDepth;
    if (options.spacing == Spacing::Even || options.look == Look::Article) {
        slabs.farDepth = volume.farShown;
        slabs.count = options.slices;
        slabs.thickness = (slabs.farDepth - slabs.nearDepth) / slabs.count;
        return slabs;
    }
    slabs.spacing = Spacing::Adaptive;
    slabs.farDepth = volume.farDepth;
    slabs.lampDepth = -pose.viewFromLight[3].z;
    const double along = pose.viewFromLight[2].z;  // of the light's axis, away from the eye
    slabs.reachBehind = reach(along, halfDiagonal(light));
    slabs.reachBefore = reach(-along, halfDiagonal(light));
    const double inBeam = narrowness(light) / slabsPerBeam;
    slabs.growth = std::min({mostGrowth, detail / slabsPerDetail, inBeam});
    const double pixel = pixelSize(view, options.pictureHeight, volume.nearDepth);
    const double thin = std::clamp(inBeam * light.nearPlane, pixel * thinBeam / slabsPerBeam, pixel * leastPixels);
    slabs.least = std::hypot(std::max(slabs.growth * light.nearPlane, thin), visible);
    const double wanted = counted(slabs, volume.farLit) - counted(slabs, volume.nearLit);
    // What lies behind walls is drawn where everything is: it may take many slabs, but not any number of them.
    const double all = counted(slabs, slabs.farDepth) - counted(slabs, slabs.nearDepth);
    // One less than may be: counting starts at the lamp, so both ends may be fractions.
    slabs.scale = std::max({1.0, wanted / std::max(options.slices - 1, 1), all / mostBehindWalls});
    slabs.first = static_cast<int>(std::ceil(counted(slabs, slabs.farDepth)));
    slabs.count = std::max(1, slabs.first - static_cast<int>(std::floor(counted(slabs, slabs.nearDepth))));
    return slabs;
}

Slab slabAt(const Slabs& slabs, int i) {
    if (slabs.spacing == Spacing::Even) return {slabs.farDepth - (i + 0.5) * slabs.thickness, slabs.thickness, i};
    const int end = slabs.first - i;
    const double far = std::min(depthAt(slabs, end), slabs.farDepth);
    const double near = std::max(depthAt(slabs, end - 1), slabs.nearDepth);
    return {0.5 * (near + far), std::max(far - near, 0.0), -end};
}

}  // namespace tyndall

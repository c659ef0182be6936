#include "slabs/slabs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shape/light_shape.h"
#include "visibility/pixel_size.h"

namespace tyndall {
namespace {

// The midpoint rule over 1/d^2 is worst for an eye that looks along the beam, where it falls short by growth^2 / 4: a
// hundredth. For rays that pass the lamp at d the error is coth(pi d / h) - 1, here 1e-13.
constexpr double maxGrowth = 0.2;
// Slabs to a feature of a cookie or a shadow map, seen at 45 degrees: two samples of each.
constexpr double slabsPerDetail = 2.0;
// Slabs per beam width, seen from the side. A pixel counts the slices within the beam, and is off by up to one: two
// slabs per width show as stripes that wind about the beam; eight show none, and nothing steps when the eye moves
// (tests/apps/continuity_test.cpp).
constexpr double slabsPerBeam = 8.0;
// Pixels between neighbouring slices in a wide beam: seen at 45 degrees, an edge steps by this many pixels.
constexpr double minPixels = 1.0;
// A beam of at most this many pixels counts as a line: its parts are not resolved.
constexpr double thinBeam = 2.0;
// The largest budget that PlanOptions::slices can ask for, less one.
constexpr double maxBehindWalls = 65535.0;

// The secant of the smallest angle between the view's axis, forwards or backwards, and a ray of the lamp. `cosine`: of
// the angle to the light's axis. `half`: the angle between that axis and the outermost rays.
double minSecant(double cosine, double half) {
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) - half;
    // Beyond 89 degrees the volume has almost nothing on that side.
    return 1.0 / std::cos(std::clamp(angle, 0.0, 1.553));
}

double secantAt(const Slabs& slabs, double offset) {
    return offset > 0.0 ? slabs.secantBehind : slabs.secantBefore;
}

// Slabs between the lamp's depth and `depth`, negative before the lamp.
double counted(const Slabs& slabs, double depth) {
    const double offset = depth - slabs.lampDepth;
    const double steepness = slabs.growth * secantAt(slabs, offset);
    return std::asinh(steepness * offset / slabs.minThickness) / (steepness * slabs.scale);
}

double depthAt(const Slabs& slabs, double count) {
    const double steepness = slabs.growth * secantAt(slabs, count);
    return slabs.lampDepth + slabs.minThickness * std::sinh(count * steepness * slabs.scale) / steepness;
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
    const LightShape shape = shapeOf(light);
    slabs.lampDepth = -pose.viewFromLight[3].z;
    const double along = pose.viewFromLight[2].z;  // cosine between the light's axis and the direction away from the
                                                   // eye
    slabs.secantBehind = minSecant(along, halfDiagonalAngle(shape));
    slabs.secantBefore = minSecant(-along, halfDiagonalAngle(shape));
    const double inBeam = narrowness(shape) / slabsPerBeam;
    slabs.growth = std::min({maxGrowth, detail / slabsPerDetail, inBeam});
    const double pixel = pixelSize(view, options.pictureHeight, volume.nearDepth);
    const double thin = std::clamp(inBeam * light.nearPlane, pixel * thinBeam / slabsPerBeam, pixel * minPixels);
    slabs.minThickness = std::hypot(std::max(slabs.growth * light.nearPlane, thin), visible);
    const double wanted = counted(slabs, volume.farLit) - counted(slabs, volume.nearLit);
    // PlanOptions::everything draws the air behind walls, too: that may take many slabs, so their number is limited.
    const double all = counted(slabs, slabs.farDepth) - counted(slabs, slabs.nearDepth);
    // One less than the maximum: counting starts at the lamp, so both ends may be fractions.
    slabs.scale = std::max({1.0, wanted / std::max(options.slices - 1, 1), all / maxBehindWalls});
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

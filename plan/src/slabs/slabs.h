// Which slabs of depth a light is drawn with.
//
// Even: N equal slabs from the farthest depth to the nearest.
//
// Adaptive: what varies in a beam varies with the distance from the lamp. 1/d^2 changes by its own size over d, the
// beam itself and the texels of cookie and shadow map are as wide as d times an angle. So slabs are as thick as
//
//   h(z) = scale * sqrt((growth * d(z))^2 + least^2),   d(z) = reach * |z - lamp|
//
// at view depth z, with d(z) the least distance from the lamp of what the pyramid has at that depth, and least what
// is too thin to be seen. Their number between the lamp's depth and z, the integral of dz / h(z), is
// asinh(growth * d(z) / least) / (growth * reach * scale): a closed form that can be inverted. Slabs end where it is
// a whole number, and where the volume does: as the lamp's own depth is where counting starts, slabs stand still in
// the beam while the eye moves towards it, and as everything here is continuous, nothing steps.
#pragma once

#include <tyndall/light.h>
#include <tyndall/plan.h>
#include <tyndall/view.h>

#include "visibility/light_volume.h"

namespace tyndall {

struct Slab {
    double middle, thickness;  ///< metres of view depth
    int number;                ///< the same for the same slab, whatever the view sees of it; grows towards the eye
};

struct Slabs {
    Spacing spacing = Spacing::Even;
    double nearDepth = 0.0, farDepth = 0.0;  ///< metres of view depth that they span
    int count = 0;                           ///< over all of that
    double thickness = 0.0;                  ///< Even: of each
    double lampDepth = 0.0, growth = 0.0, least = 0.0, scale = 1.0;
    double reachBefore = 1.0, reachBehind = 1.0;  ///< reach between eye and lamp, and beyond the lamp
    int first = 0;                                ///< Adaptive: number of the farthest
};

/// `detail`: the finest lateral feature of what the light is drawn with, over its distance from the lamp (an angle,
/// radians); infinite where there is none. `visible`: metres of air whose light the display shows.
Slabs slabsOf(const Light& light, const View& view, const PlanOptions& options, const LightPose& pose,
              const LightVolume& volume, double detail, double visible);

/// Slab `i` of `count`, 0 the farthest.
Slab slabAt(const Slabs& slabs, int i);

}  // namespace tyndall

// Which slabs of depth a light is drawn with.
//
// Even: N equal slabs from the farthest depth to the nearest.
//
// Adaptive: everything in a beam grows with the distance d from the lamp. 1/d^2 changes by its own size over d; the
// beam itself and the texels of cookie and shadow map are as wide as d times an angle. So slabs are as thick as
//
//   h(z) = scale * sqrt((growth * d(z))^2 + minThickness^2),   d(z) = secant * |z - lamp|
//
// at view depth z. d(z) is the smallest distance from the lamp that the light's volume has at that depth, and a slab of
// minThickness is too thin to be seen. The number of slabs between the lamp's depth and z, the integral of dz / h(z),
// is asinh(growth * d(z) / minThickness) / (growth * secant * scale): a closed form with an inverse. Slabs end at whole
// numbers of this, and at the ends of the volume. Counting starts at the lamp's own depth, so slabs stand still in the
// beam while the eye moves towards it. Everything here is continuous, so nothing steps.
#pragma once

#include <tyndall/light.h>
#include <tyndall/plan.h>
#include <tyndall/view.h>

#include "visibility/light_volume.h"

namespace tyndall {

struct Slab {
    double middle, thickness;  ///< metres of view depth
    int number;                ///< of the slab, the same in every view; grows towards the eye
};

struct Slabs {
    Spacing spacing = Spacing::Even;
    double nearDepth = 0.0, farDepth = 0.0;  ///< metres of view depth that they span
    int count = 0;                           ///< over all of that
    double thickness = 0.0;                  ///< Even: of each
    double lampDepth = 0.0, growth = 0.0, minThickness = 0.0, scale = 1.0;
    double secantBefore = 1.0, secantBehind = 1.0;  ///< secant between eye and lamp, and beyond the lamp
    int first = 0;                                  ///< Adaptive: number of the farthest
};

/// `detail`: the width of the finest feature that the light is drawn with, over its distance from the lamp (an angle,
/// radians); infinite without one. `visible`: metres of air whose light the display shows.
Slabs slabsOf(const Light& light, const View& view, const PlanOptions& options, const LightPose& pose,
              const LightVolume& volume, double detail, double visible);

/// Slab `i` of `count`, 0 the farthest.
Slab slabAt(const Slabs& slabs, int i);

}  // namespace tyndall

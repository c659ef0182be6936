// The triangles that slices are drawn with.
//
// Slices are numbered from the farthest to the nearest: slice i of N stands for the slab between the view
// depths farDepth - i h and farDepth - (i + 1) h with h = (farDepth - nearDepth) / N, and lies in its
// middle. Routed, slice i goes to channel i mod 4.
#pragma once

#include <tyndall/plan.h>

#include "light_volume.h"

namespace tyndall {

/// Appends the light's exact polygons and sets its index range.
void appendPolygons(Plan& plan, PlannedLight& light, const LightVolume& volume);

/// Sets the light's index range to unit-cube quads for its slices, which lights share: they differ in
/// their bounds alone. Appends them where no light before had any.
void appendQuads(Plan& plan, PlannedLight& light);

}  // namespace tyndall

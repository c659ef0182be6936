// The triangles that slices are drawn with.
//
// Slabs are numbered from the farthest to the nearest; a slice lies in its slab's middle. Routed, the slice of slab
// number n goes to channel n mod 4.
#pragma once

#include <tyndall/plan.h>

#include <span>
#include <vector>

#include "plan_stages.h"

namespace tyndall {

/// Appends the light's exact polygons and its one or two parts: the air before the first occluder, if a separate draw
/// for it pays, and the rest. `scratch` is working memory.
void appendPolygons(Plan& plan, PlannedLight& light, const Light& source, const Candidate& candidate,
                    const PlanOptions& options, std::vector<std::uint32_t>& scratch);

/// Appends the light's one part with Method::Raycast: its outline in the picture. It has the constants that
/// Plan::raycasts got last.
void appendOutlined(Plan& plan, PlannedLight& light, std::span<const glm::dvec2> corners);

/// Appends one part of unit-cube quads for the light's slabs. Lights with even slabs differ only in their bounds and
/// share one set of quads: only the first light appends it.
void appendQuads(Plan& plan, PlannedLight& light, const Candidate& candidate, const PlanOptions& options);

}  // namespace tyndall

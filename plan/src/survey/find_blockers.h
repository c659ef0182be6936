// The planes of a scene with the largest areas.
#pragma once

#include <tyndall/blocker_set.h>

#include <span>
#include <vector>

namespace tyndall {

/// See BlockerSet::fromMeshes(). Meshes and instances must have passed checkMeshes().
std::vector<Blocker> findBlockers(std::span<const MeshTriangles> meshes, std::span<const MeshInstance> instances);

}  // namespace tyndall

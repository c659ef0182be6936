// The large flat parts of a scene: floors, walls, backdrops.
#pragma once

#include <tyndall/surroundings.h>

#include <vector>

#include "../scene/scene.h"

namespace tyndall::app {

/// Triangles of all instances that lie in one plane, for the planes with most area: at most 64, of at least a
/// thousandth of the largest.
std::vector<Blocker> findBlockers(const Scene& scene);

}  // namespace tyndall::app

// Boxes around what stands in a scene's light.
#pragma once

#include <tyndall/surroundings.h>

#include <vector>

#include "../scene/scene.h"

namespace tyndall::app {

/// Boxes that together hold all triangles of all instances. A mesh has as many as follow its shape: one around a lamp
/// post with its arm would hold the lamp's whole cone.
std::vector<OccluderBox> occluderBoxes(const Scene& scene);

}  // namespace tyndall::app

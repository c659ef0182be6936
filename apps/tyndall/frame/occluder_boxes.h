// Boxes around what stands in a scene's light.
#pragma once

#include <tyndall/surroundings.h>

#include <vector>

#include "../scene/scene.h"

namespace tyndall::app {

/// Boxes that together hold all triangles of all instances, and the triangles, which they point into.
struct OccluderBoxes {
    std::vector<std::vector<std::array<glm::vec3, 3>>> triangles;  ///< by mesh
    std::vector<OccluderBox> boxes;
    std::vector<std::size_t> instances;  ///< of Scene::instances, by box
};

/// A mesh has as many boxes as follow its shape: one around a lamp post with its arm would hold the lamp's whole cone.
OccluderBoxes occluderBoxes(const Scene& scene);

/// Takes the boxes to where their instances are. False where none had moved.
bool moveBoxes(OccluderBoxes& occluders, const Scene& scene);

}  // namespace tyndall::app

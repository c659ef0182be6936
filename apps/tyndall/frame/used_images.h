// The images that the drawn parts of a scene use; the others are not uploaded.
#pragma once

#include <tyndall/plan.h>

#include <span>
#include <vector>

#include "surface_lights.h"
#include "view_scene.h"

namespace tyndall::app {

/// By Scene::images: those on lit surfaces, and the cookies of their lights. Without `lit` there are none.
std::vector<bool> surfaceImages(const ViewedScene& viewed, std::span<const SurfaceLight> lights, bool lit);

/// By Scene::images: the cookies and noise textures that `plan`'s parts use.
std::vector<bool> shaftImages(const Scene& scene, const Plan& plan);

}  // namespace tyndall::app

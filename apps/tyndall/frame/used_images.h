// Which of a scene's pictures are looked at by what is drawn: the others are not uploaded.
#pragma once

#include <tyndall/plan.h>

#include <span>
#include <vector>

#include "surface_lights.h"
#include "view_scene.h"

namespace tyndall::app {

/// By Scene::images: those on lit surfaces, and the cookies of the lights that light them. None without `lit`.
std::vector<bool> surfaceImages(const ViewedScene& viewed, std::span<const SurfaceLight> lights, bool lit);

/// By Scene::images: the cookies and noise of the parts that `plan` draws with them.
std::vector<bool> shaftImages(const Scene& scene, const Plan& plan);

}  // namespace tyndall::app

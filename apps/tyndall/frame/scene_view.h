// The scene as one of its cameras sees it.
#pragma once

#include <kit/fail.h>
#include <tyndall/view.h>

#include <span>
#include <vector>

#include "../scene/scene.h"
#include "view_options.h"

namespace tyndall::app {

/// The camera of that name, or the first. Errors: no such name; the message lists all names.
Result<const Camera*> chooseCamera(const Scene& scene, const std::optional<std::string>& name);

/// Keeps the camera's height; the width follows from the picture's aspect ratio.
View viewFrom(const Camera& camera, Size size);

/// For each light the indices of the instances whose boxes may intersect its volume: those that it can light, and that
/// can cast a shadow in it.
std::vector<std::vector<std::size_t>> instancesByLight(const Scene& scene, std::span<const Light> lights);

}  // namespace tyndall::app

// The scene from one of its cameras.
#pragma once

#include <tyndall/view.h>

#include <span>
#include <vector>

#include <kit/fail.h>
#include "../scene/scene.h"
#include "view_options.h"

namespace tyndall::app {

/// The camera of that name, or the first. Errors: no such name; the message lists what there is.
Result<const Camera*> chooseCamera(const Scene& scene, const std::optional<std::string>& name);

/// The camera's height is kept, its width follows the picture's shape.
View viewFrom(const Camera& camera, Size size);

/// For each light the instances, as numbers, whose boxes cannot be proved to lie outside of its volume: those that it
/// can light, and that can throw a shadow in it.
std::vector<std::vector<std::size_t>> instancesByLight(const Scene& scene, std::span<const Light> lights);

}  // namespace tyndall::app

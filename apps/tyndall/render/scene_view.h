// The scene from one of its cameras.
#pragma once

#include <tyndall/view.h>

#include "../options.h"
#include "../scene/scene.h"

namespace tyndall::app {

/// The camera of that name, or the first. Errors: no such name; the message lists what there is.
Outcome<const Camera*> chooseCamera(const Scene& scene, const std::optional<std::string>& name);

/// The camera's height is kept, its width follows the picture's shape.
View viewFrom(const Camera& camera, Size size);

/// Lights whose shadow flag is cleared where nothing stands in their volume: a scene that throws no shadow
/// needs no shadow map.
std::vector<Light> callForShadows(const Scene& scene);

}  // namespace tyndall::app

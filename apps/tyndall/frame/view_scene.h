// From a file and options to a camera's view: the common part of all commands on scenes.
#pragma once

#include <kit/fail.h>
#include <tyndall/light.h>
#include <tyndall/view.h>

#include <vector>

#include "../scene/scene.h"
#include "view_options.h"

namespace tyndall::app {

struct ViewedScene {
    Scene scene;
    const Camera* camera = nullptr;  ///< in scene.cameras
    View view;
    std::vector<Light> lights;                               ///< of scene.lights, in their order
    std::vector<std::vector<std::size_t>> instancesInLight;  ///< see instancesByLight()
};

Result<ViewedScene> viewScene(const ViewOptions& options);

}  // namespace tyndall::app

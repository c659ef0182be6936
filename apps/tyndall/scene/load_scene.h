// Loads a scene from a glTF file.
#pragma once

#include <kit/fail.h>

#include <string>

#include "scene.h"

namespace tyndall::app {

/// Reads `path` with its animations at `time` seconds. Errors: a broken file, no camera, no light, a light
/// or camera that cannot be drawn. Parts that are left out give warnings in the scene.
Result<Scene> loadScene(const std::string& path, double time);

}  // namespace tyndall::app

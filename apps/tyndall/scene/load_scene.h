// A scene out of a glTF file.
#pragma once

#include <string>

#include <kit/fail.h>
#include "scene.h"

namespace tyndall::app {

/// Reads `path` with its animations at `time` seconds. Errors: a file that is broken anywhere, no camera,
/// no light, a light or camera that cannot be drawn. What is only left out is a warning in the scene.
Result<Scene> loadScene(const std::string& path, double time);

}  // namespace tyndall::app

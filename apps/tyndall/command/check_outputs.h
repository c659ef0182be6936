// Checks that a command's output files can be written, before work of seconds or hours begins.
#pragma once

#include <kit/fail.h>

#include <optional>
#include <string>

namespace tyndall::app {

/// The files must differ from each other and from the scene.
Result<void> checkOutputs(const std::string& scene, const std::string& picture,
                          const std::optional<std::string>& stats);

}  // namespace tyndall::app

// Whether the files that a command is to write can be written, asked before work of seconds or hours begins.
#pragma once

#include <optional>
#include <string>

#include <kit/fail.h>

namespace tyndall::app {

/// Neither takes the other's place nor that of the scene.
Result<void> checkOutputs(const std::string& scene, const std::string& picture,
                           const std::optional<std::string>& stats);

}  // namespace tyndall::app

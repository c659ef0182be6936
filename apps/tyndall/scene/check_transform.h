// Checks a glTF node's own transform.
#pragma once

#include <kit/fail.h>

#include <nlohmann/json.hpp>
#include <string>

namespace tyndall::app {

/// glTF 2.0, section 5.25: translation and scale of 3 numbers, a rotation of 4 that are not all 0, a matrix of
/// 16. `place` names the node. A reader that skipped wrong values would place the node wrongly without an error.
Result<void> checkTransform(const nlohmann::json& node, const std::string& place);

}  // namespace tyndall::app

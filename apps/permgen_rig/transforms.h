// Matrices as a fixture writes them: {"perspective": …}, {"lookAt": …} and their product.
#pragma once

#include "fixture.h"
#include "json_value.h"

namespace tyndall::rig {

/// True if the value is an object; only matrices are objects.
bool isTransform(const JsonValue& value);

/// Sixteen numbers in the shape {4, 4}, rows as mul(matrix, vector) has them.
Numbers readTransform(const JsonValue& value);

}  // namespace tyndall::rig

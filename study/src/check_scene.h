// Checks a reference scene before it is used.
#pragma once

#include <study/reference.h>

namespace tyndall::study {

/// Errors: the first broken rule, with its place and a remedy.
Result<void> checkScene(const ReferenceScene& scene, const ReferenceOptions& options);

}  // namespace tyndall::study

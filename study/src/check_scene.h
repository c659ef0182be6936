// What a reference scene has to be before any of it is used.
#pragma once

#include <study/reference.h>

namespace tyndall::study {

/// Errors: the first broken rule, with its place and what to do.
Result<void> checkScene(const ReferenceScene& scene, const ReferenceOptions& options);

}  // namespace tyndall::study

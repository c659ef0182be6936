#pragma once

#include "device_core.h"

namespace headless {

/// Fills core.instance, and core.messenger if validation is on.
Result<void> createInstance(DeviceCore& core, const DeviceOptions& options);

}  // namespace headless

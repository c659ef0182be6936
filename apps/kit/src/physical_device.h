#pragma once

#include "device_core.h"

namespace headless {

/// Fills physicalDevice, queueFamily, properties, memoryProperties and pipelineStatistics of `core`.
Result<void> choosePhysicalDevice(DeviceCore& core, const DeviceOptions& options);

}  // namespace headless

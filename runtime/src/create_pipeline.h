// Creates one VkPipeline, which draws or computes.
#pragma once

#include <tyndall/pass_pipelines.h>

#include <span>

#include "gpu_context.h"
#include "pipeline_layouts.h"

namespace tyndall {

/// Draws `layout`'s pass. Thread-safe, unless the pipeline cache is externally synchronized.
/// Errors: see PassPipelines::get().
Result<VkPipeline> createPipeline(const Gpu& gpu, const PassLayout& layout, Shaders shaders, const PassTarget& target,
                                  std::span<const VkVertexInputAttributeDescription> attributes);

/// Computes `layout`'s pass. Thread-safe under the same condition.
/// Errors: see PassPipelines::get().
Result<VkPipeline> createComputePipeline(const Gpu& gpu, const PassLayout& layout, Shaders shaders);

}  // namespace tyndall

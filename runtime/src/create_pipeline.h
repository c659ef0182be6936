// One VkPipeline from all that it is made of.
#pragma once

#include <tyndall/pass_pipelines.h>

#include <span>

#include "gpu_context.h"
#include "pipeline_layouts.h"

namespace tyndall {

/// Of `layout`'s pass. Safe to call from several threads at once, but for a pipeline cache that is externally
/// synchronized: it uses nothing that another call changes.
/// Errors: as PassPipelines::get().
Result<VkPipeline> createPipeline(const Gpu& gpu, const PassLayout& layout, Shaders shaders, const PassTarget& target,
                                  std::span<const VkVertexInputAttributeDescription> attributes);

}  // namespace tyndall

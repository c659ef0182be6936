// The pipeline of each of a Renderer's passes. Recording and prepare() both use these functions.
#pragma once

#include "renderer_impl.h"

namespace tyndall {

/// `depth` UNDEFINED: no depth test.
PassTarget accumulationTarget(Accumulation accumulation, VkFormat depth, VkCompareOp compare);

PipelineRequest slicePipeline(const Renderer::Impl& impl, TermSet terms, const PassTarget& target);

PipelineRequest compositePipeline(const Renderer::Impl& impl, Accumulation accumulation, bool blur, VkFormat colour);

PipelineRequest shadowMapPipeline(const Renderer::Impl& impl, VkFormat map);

}  // namespace tyndall

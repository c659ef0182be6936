// The pipeline of each of a Renderer's passes. Recording and prepare() both use these functions.
#pragma once

#include "renderer_impl.h"

namespace tyndall {

/// `depth` UNDEFINED: no depth test.
PassTarget accumulationTarget(Accumulation accumulation, VkFormat depth, VkCompareOp compare);

/// Of one part of a plan.
PipelineRequest shaftPipeline(const Renderer::Impl& impl, Method method, TermSet terms, const PassTarget& target);

PipelineRequest compositePipeline(const Renderer::Impl& impl, Accumulation accumulation, bool blur, VkFormat colour);

PipelineRequest shadowMapPipeline(const Renderer::Impl& impl, VkFormat map);

/// `fromMap`: draws the first level; otherwise one of the others.
PipelineRequest shadowHierarchyPipeline(const Renderer::Impl& impl, bool fromMap);

}  // namespace tyndall

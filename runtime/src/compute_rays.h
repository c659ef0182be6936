// Method::Raycast in compute shaders: adds a plan's parts to the accumulation image, one dispatch for each.
#pragma once

#include <tyndall/raycast_data.h>

#include "renderer_impl.h"

namespace tyndall {

/// The uniform block of raycast_compute.fx.
struct ComputedRays {
    RaycastConstants rays;
    glm::vec4 tile;
};

/// Whether parts with this method are computed: the accumulation image is a storage image (ShaftTargets::storage) of a
/// format that the shader has.
bool isComputed(Method method, Accumulation accumulation, bool storage);

/// The pipeline of the part's terms for that format; made on first use.
Result<PassPipeline> raysPipeline(Renderer::Impl& impl, Accumulation accumulation, TermSet terms);

/// The rectangle of pixels around the part's outline.
glm::vec4 tileOf(const Plan& plan, const PlannedPart& part, VkExtent2D extent);

/// Dispatches the computed ones of impl.draws. Layout of the accumulation image before: COLOR_ATTACHMENT_OPTIMAL;
/// after: SHADER_READ_ONLY_OPTIMAL. Record it outside of rendering.
Result<void> computeRays(Renderer::Impl& impl, VkCommandBuffer commands, const ShaftTargets& targets);

}  // namespace tyndall

// Direct3D 9 render states, as a pass writes them, in Vulkan's words.
#pragma once

#include <permgen/tables.h>
#include <tyndall/result.h>
#include <vulkan/vulkan_core.h>

#include <optional>
#include <span>

namespace tyndall {

struct PassStates {
    VkPipelineColorBlendAttachmentState blend{};
    bool depthTest = true;
    bool depthWrite = true;
    std::optional<VkCompareOp> depthCompare;       ///< where the pass writes ZFunc
    VkCullModeFlags cull = VK_CULL_MODE_BACK_BIT;  ///< front faces are clockwise, as Direct3D has it
};

/// What `states` amount to, on top of Direct3D 9's defaults (opaque, depth tested and written, back faces
/// culled). Of two settings of a state the later counts. States without effect are left alone, and permgen
/// warns of them; a state that every draw has one value of (permgen/d3d9/states.h) may have that one.
/// Errors: InvalidArgument naming the state, or the value, that has no meaning here.
Result<PassStates> passStates(std::span<const permgen::State> states);

}  // namespace tyndall

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
/// culled). Names compare without case; of two settings of a state the later counts. States of the
/// fixed-function pipeline are accepted where they switch it off.
/// Errors: InvalidArgument naming the state, or the value, that has no meaning here.
Result<PassStates> passStates(std::span<const permgen::State> states);

}  // namespace tyndall

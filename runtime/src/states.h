// Converts a pass's Direct3D 9 render states to Vulkan's.
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
    std::optional<VkCompareOp> depthCompare;       ///< if the pass sets ZFunc
    VkCullModeFlags cull = VK_CULL_MODE_BACK_BIT;  ///< front faces are clockwise, as in Direct3D
};

/// `states` applied to Direct3D 9's defaults (opaque, depth tested and written, back faces culled). The later of two
/// settings of a state wins. States without effect are ignored; permgen warns of them. A state with one supported value
/// (permgen/d3d9/states.h) may have that value.
/// Errors: InvalidArgument naming the unsupported state or value.
Result<PassStates> passStates(std::span<const permgen::State> states);

}  // namespace tyndall

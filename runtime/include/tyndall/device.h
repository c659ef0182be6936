// The caller's device, and the builds of the effects to draw with.
//
// The device needs Vulkan 1.3 with dynamicRendering, synchronization2 and separateDepthStencilLayouts
// enabled, the feature shaderClipDistance and the extension VK_KHR_push_descriptor.
#pragma once

#include <permgen/tables.h>
#include <vulkan/vulkan_core.h>

namespace tyndall {

/// Which shader modules pipelines use. Both draw the same picture, bit for bit.
enum class Shaders {
    Frozen,       ///< the technique's own module without dead code: only resources that it needs are bound
    Specialized,  ///< the one module that all techniques share, with its specialization constants set. All its
                  ///< resources must be bound (Vulkan counts a resource as used before specialization); those that the
                  ///< technique does not need get neutral textures
};

struct DeviceContext {
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkPipelineCache pipelineCache = VK_NULL_HANDLE;  ///< may be null
    Shaders shaders = Shaders::Frozen;

    /// Other builds of the Renderer's effects, with frozen modules, for instance loaded from a manifest. Null: the
    /// built-in ones. They must outlive the Renderer.
    const permgen::Effect* slices = nullptr;           ///< of slices.fx
    const permgen::Effect* raycast = nullptr;          ///< of raycast.fx
    const permgen::Effect* composite = nullptr;        ///< of composite.fx
    const permgen::Effect* shadowMap = nullptr;        ///< of shadow_map.fx
    const permgen::Effect* shadowHierarchy = nullptr;  ///< of shadow_hierarchy.fx
};

}  // namespace tyndall

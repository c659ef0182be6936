// The caller's device, and which builds of the effects are drawn with on it.
//
// The device needs Vulkan 1.3 with dynamicRendering, synchronization2 and separateDepthStencilLayouts
// enabled, the feature shaderClipDistance and the extension VK_KHR_push_descriptor.
#pragma once

#include <permgen/tables.h>
#include <vulkan/vulkan_core.h>

namespace tyndall {

/// What pipelines are made of. Both draw the same picture, bit for bit.
enum class Shaders {
    Frozen,       ///< the technique's own module without dead code: only what it needs is bound
    Specialized,  ///< the one module that all techniques share, with its specialization constants set. What
                  ///< it declares must be bound, needed or not (Vulkan counts a resource as used before
                  ///< specialization): what the technique does not need is bound to neutral textures
};

struct DeviceContext {
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkPipelineCache pipelineCache = VK_NULL_HANDLE;  ///< may be null
    Shaders shaders = Shaders::Frozen;

    /// Other builds of the Renderer's own effects, with frozen modules: loaded from a manifest, say. Null: the
    /// ones built in. The caller keeps them alive as long as the Renderer.
    const permgen::Effect* slices = nullptr;     ///< of slices.fx
    const permgen::Effect* composite = nullptr;  ///< of composite.fx
    const permgen::Effect* shadowMap = nullptr;  ///< of shadow_map.fx
};

}  // namespace tyndall

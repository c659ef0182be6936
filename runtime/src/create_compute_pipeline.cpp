#include <tyndall/image_format.h>

#include "create_pipeline.h"
#include "shader_stages.h"

namespace tyndall {
namespace {

Result<void> checkGroup(const Gpu& gpu, const permgen::Module& module) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(gpu.physicalDevice, &properties);
    const VkPhysicalDeviceLimits& limits = properties.limits;
    std::uint64_t threads = 1;
    for (std::size_t axis = 0; axis < module.group_size.size(); ++axis) {
        threads *= module.group_size[axis];
        if (module.group_size[axis] > limits.maxComputeWorkGroupSize[axis])
            return unsupported("the device's thread groups have " +
                               std::to_string(limits.maxComputeWorkGroupSize[axis]) + " threads along axis " +
                               std::to_string(axis) + " at most, and " + std::string(module.name) + " wants " +
                               std::to_string(module.group_size[axis]) + "; write a smaller [numthreads]");
    }
    if (threads > limits.maxComputeWorkGroupInvocations)
        return unsupported("the device's thread groups have " + std::to_string(limits.maxComputeWorkGroupInvocations) +
                           " threads at most, and " + std::string(module.name) + " wants " + std::to_string(threads) +
                           "; write a smaller [numthreads]");
    return {};
}

Result<void> checkImages(const Gpu& gpu, const PassLayout& layout) {
    for (const permgen::Resource* resource : layout.bound) {
        if (resource->kind != permgen::ResourceKind::StorageImage) continue;
        const VkFormat format = vulkanFormat(resource->format);
        VkFormatProperties properties;
        vkGetPhysicalDeviceFormatProperties(gpu.physicalDevice, format, &properties);
        if (!(properties.optimalTilingFeatures & VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT))
            return unsupported("the device has no storage images of " + formatName(format) +
                               "; give another image format to " + std::string(resource->name));
    }
    return {};
}

}  // namespace

Result<VkPipeline> createComputePipeline(const Gpu& gpu, const PassLayout& layout, Shaders shaders) {
    if (auto checked = checkGroup(gpu, *layout.pass->compute.module); !checked) return tl::unexpected(checked.error());
    if (auto checked = checkImages(gpu, layout); !checked) return tl::unexpected(checked.error());
    ShaderStages stages(gpu);
    if (auto loaded = stages.load(*layout.pass, shaders); !loaded) return tl::unexpected(loaded.error());

    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage = stages.data()[0];
    info.layout = layout.pipeline;
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult result = vkCreateComputePipelines(gpu.device, gpu.pipelineCache, 1, &info, nullptr, &pipeline);
    if (result != VK_SUCCESS) return vulkanError("vkCreateComputePipelines", result);
    return pipeline;
}

}  // namespace tyndall

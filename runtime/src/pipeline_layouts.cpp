#include "pipeline_layouts.h"

#include <algorithm>

#include "samplers.h"

namespace tyndall {
namespace {

VkDescriptorType descriptorType(permgen::ResourceKind kind) {
    constexpr VkDescriptorType types[] = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                          VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
    return types[static_cast<std::size_t>(kind)];
}

Result<void> checkBound(std::span<const permgen::Resource* const> bound, std::string_view name) {
    if (bound.size() > maxBoundResources)
        return invalidArgument(std::string(name) + " binds more than " + std::to_string(maxBoundResources) +
                               " resources; use fewer");
    for (const permgen::Resource* resource : bound)
        if (resource->set != 0)
            return invalidArgument("the resource " + std::string(resource->name) + " of " + std::string(name) +
                                   " is in descriptor set " + std::to_string(resource->set) +
                                   "; the renderer binds set 0 only");
    return {};
}

Result<void> createSamplers(const Gpu& gpu, PassLayout& layout) {
    layout.samplers.assign(layout.bound.size(), VK_NULL_HANDLE);
    for (std::size_t i = 0; i < layout.samplers.size(); ++i) {
        const permgen::Resource& resource = *layout.bound[i];
        if (resource.kind != permgen::ResourceKind::CombinedImageSampler) continue;
        const auto info = samplerInfo(resource.sampler_states);
        if (!info) return invalidArgument(std::string(resource.name) + ": " + info.error().message);
        const VkResult result = vkCreateSampler(gpu.device, &*info, nullptr, &layout.samplers[i]);
        if (result != VK_SUCCESS) return vulkanError("vkCreateSampler", result);
        setName(gpu, VK_OBJECT_TYPE_SAMPLER, layout.samplers[i], resource.name);
    }
    return {};
}

Result<void> createLayouts(const Gpu& gpu, PassLayout& layout, std::string_view name) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const permgen::Resource* resource : layout.bound) {
        VkDescriptorSetLayoutBinding binding{};
        binding.binding = resource->binding;
        binding.descriptorType = descriptorType(resource->kind);
        binding.descriptorCount = 1;
        binding.stageFlags = layout.pass->compute.module ? VK_SHADER_STAGE_COMPUTE_BIT
                                                         : VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
        bindings.push_back(binding);
    }
    VkDescriptorSetLayoutCreateInfo setInfo{};
    setInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    setInfo.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
    setInfo.bindingCount = static_cast<std::uint32_t>(bindings.size());
    setInfo.pBindings = bindings.data();
    VkResult result = vkCreateDescriptorSetLayout(gpu.device, &setInfo, nullptr, &layout.set);
    if (result != VK_SUCCESS) return vulkanError("vkCreateDescriptorSetLayout", result);
    setName(gpu, VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, layout.set, name);

    VkPipelineLayoutCreateInfo pipelineInfo{};
    pipelineInfo.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    pipelineInfo.setLayoutCount = 1;
    pipelineInfo.pSetLayouts = &layout.set;
    result = vkCreatePipelineLayout(gpu.device, &pipelineInfo, nullptr, &layout.pipeline);
    if (result != VK_SUCCESS) return vulkanError("vkCreatePipelineLayout", result);
    setName(gpu, VK_OBJECT_TYPE_PIPELINE_LAYOUT, layout.pipeline, name);
    return {};
}

}  // namespace

std::vector<const permgen::Resource*> boundResources(const permgen::Effect& effect, const permgen::Pass& pass,
                                                     Shaders shaders) {
    if (shaders == Shaders::Frozen) return {pass.live.begin(), pass.live.end()};
    std::vector<const permgen::Resource*> all;
    for (const permgen::Resource& resource : effect.resources) all.push_back(&resource);
    return all;
}

Result<PassLayout> createLayout(const Gpu& gpu, const permgen::Pass& pass, std::vector<const permgen::Resource*> bound,
                                std::string_view name) {
    if (auto checked = checkBound(bound, name); !checked) return tl::unexpected(checked.error());
    PassLayout layout;
    layout.pass = &pass;
    layout.bound = std::move(bound);
    auto made = createSamplers(gpu, layout);
    if (made) made = createLayouts(gpu, layout, name);
    if (!made) {
        destroyLayout(gpu, layout);
        return tl::unexpected(made.error());
    }
    return layout;
}

void destroyLayout(const Gpu& gpu, PassLayout& layout) {
    vkDestroyPipelineLayout(gpu.device, layout.pipeline, nullptr);
    vkDestroyDescriptorSetLayout(gpu.device, layout.set, nullptr);
    for (VkSampler sampler : layout.samplers) vkDestroySampler(gpu.device, sampler, nullptr);
    layout = {};
}

VkImageView StandIns::storageImage(const permgen::Resource& resource) const {
    const auto found = storageImages.find({resource.format, resource.dimension});
    return found == storageImages.end() ? VK_NULL_HANDLE : found->second;
}

bool binds(const PassLayout& layout, std::string_view resource) {
    return std::any_of(layout.bound.begin(), layout.bound.end(),
                       [&](const permgen::Resource* bound) { return bound->name == resource; });
}

Result<std::uint32_t> pushResources(const Gpu& gpu, VkCommandBuffer commands, const PassLayout& layout,
                                    std::span<const NamedBuffer> buffers, std::span<const NamedImage> images,
                                    const StandIns& standIns) {
    std::array<VkWriteDescriptorSet, maxBoundResources> writes{};
    std::array<VkDescriptorBufferInfo, maxBoundResources> bufferInfos{};
    std::array<VkDescriptorImageInfo, maxBoundResources> imageInfos{};
    std::uint32_t count = 0;
    for (const permgen::Resource* resource : layout.bound) {
        const bool dead = !permgen::is_live(*layout.pass, resource->name);
        VkWriteDescriptorSet& write = writes[count];
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstBinding = resource->binding;
        write.descriptorCount = 1;
        write.descriptorType = descriptorType(resource->kind);
        const bool storage = write.descriptorType == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        if (storage || write.descriptorType == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER) {
            VkDescriptorBufferInfo& info = bufferInfos[count];
            const VkDescriptorBufferInfo& standIn = storage ? standIns.storageBuffer : standIns.buffer;
            if (dead) info = {standIn.buffer, standIn.offset, resource->size};
            for (const NamedBuffer& buffer : buffers)
                if (buffer.block == resource->name && buffer.buffer.buffer) info = buffer.buffer;
            if (!info.buffer)
                return invalidArgument((storage ? "the storage buffer " : "the uniform block ") +
                                       std::string(resource->name) + " has no buffer" + (storage ? "" : " to read"));
            write.pBufferInfo = &info;
        } else {
            const bool written = write.descriptorType == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
            VkDescriptorImageInfo& info = imageInfos[count];
            if (dead && written)
                info = {VK_NULL_HANDLE, standIns.storageImage(*resource), VK_IMAGE_LAYOUT_GENERAL};
            else if (dead)
                info = {VK_NULL_HANDLE, standIns.images[static_cast<std::size_t>(resource->dimension)],
                        VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
            for (const NamedImage& image : images)
                if (image.sampler == resource->name && image.view) info = {VK_NULL_HANDLE, image.view, image.layout};
            if (!info.imageView)
                return invalidArgument((written ? "the storage image " : "the sampler ") + std::string(resource->name) +
                                       " has no image" + (written ? "" : " to read"));
            info.sampler = layout.samplers[count];
            write.pImageInfo = &info;
        }
        ++count;
    }
    if (count > 0)
        gpu.pushDescriptorSet(
            commands, layout.pass->compute.module ? VK_PIPELINE_BIND_POINT_COMPUTE : VK_PIPELINE_BIND_POINT_GRAPHICS,
            layout.pipeline, 0, count, writes.data());
    return count;
}

}  // namespace tyndall

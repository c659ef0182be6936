#include "surface_pipelines.h"

#include <scene.fx.h>
#include <vulkan/vulkan.h>

#include <cstddef>

#include "../scene/scene.h"

namespace tyndall::app {
namespace {

struct Element {
    std::string_view semantic;
    std::uint32_t offset;
    VkFormat format;
};

constexpr std::array<Element, 3> elements{{{"POSITION0", offsetof(Vertex, position), VK_FORMAT_R32G32B32_SFLOAT},
                                           {"NORMAL0", offsetof(Vertex, normal), VK_FORMAT_R32G32B32_SFLOAT},
                                           {"TEXCOORD0", offsetof(Vertex, uv), VK_FORMAT_R32G32_SFLOAT}}};

VkDescriptorType descriptorType(const permgen::Resource& resource) {
    return resource.kind == permgen::ResourceKind::UniformBuffer ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
                                                                 : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
}

VkResult createSampler(VkDevice device, const permgen::Resource& resource, VkSampler& sampler) {
    const auto has = [&](std::string_view name, std::string_view value) {
        for (const permgen::State& state : resource.sampler_states)
            if (state.name == name) return state.value == value;
        return false;
    };
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.minFilter = has("MinFilter", "LINEAR") ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    info.magFilter = has("MagFilter", "LINEAR") ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    const auto address = [&](std::string_view name) {
        return has(name, "CLAMP") ? VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE : VK_SAMPLER_ADDRESS_MODE_REPEAT;
    };
    info.addressModeU = address("AddressU");
    info.addressModeV = address("AddressV");
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    return vkCreateSampler(device, &info, nullptr, &sampler);
}

VkResult createLayouts(VkDevice device, SurfacePipeline& pipeline) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const permgen::Resource* resource : pipeline.pass->live) {
        bindings.push_back({resource->binding, descriptorType(*resource), 1, VK_SHADER_STAGE_ALL_GRAPHICS, nullptr});
        VkSampler& sampler = pipeline.samplers.emplace_back(VK_NULL_HANDLE);
        if (resource->kind == permgen::ResourceKind::UniformBuffer) continue;
        if (const VkResult made = createSampler(device, *resource, sampler); made != VK_SUCCESS) return made;
    }
    VkDescriptorSetLayoutCreateInfo set{};
    set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    set.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
    set.bindingCount = static_cast<std::uint32_t>(bindings.size());
    set.pBindings = bindings.data();
    if (const VkResult made = vkCreateDescriptorSetLayout(device, &set, nullptr, &pipeline.set); made != VK_SUCCESS)
        return made;
    VkPipelineLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout.setLayoutCount = 1;
    layout.pSetLayouts = &pipeline.set;
    return vkCreatePipelineLayout(device, &layout, nullptr, &pipeline.layout);
}

/// A shader, frozen: what its switches turn off is not in the code, so the layout need not hold it.
struct Stage {
    VkPipelineShaderStageCreateInfo info{};
    std::string entry;

    VkResult load(VkDevice device, const permgen::Shader& shader, VkShaderStageFlagBits stage) {
        entry = shader.module->entry;
        VkShaderModuleCreateInfo code{};
        code.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        code.codeSize = shader.frozen.size_bytes();
        code.pCode = shader.frozen.data();
        info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        info.stage = stage;
        info.pName = entry.c_str();
        return vkCreateShaderModule(device, &code, nullptr, &info.module);
    }
};

VkResult createPipeline(VkDevice device, SurfacePipeline& pipeline, std::array<Stage, 2>& stages, VkFormat colour,
                        VkFormat depthFormat) {
    const permgen::Pass& pass = *pipeline.pass;
    std::vector<VkVertexInputAttributeDescription> attributes;
    for (const permgen::Attribute& attribute : pass.vertex.module->attributes)
        for (const Element& element : elements)
            if (element.semantic == attribute.semantic)
                attributes.push_back({attribute.location, 0, element.format, element.offset});
    const VkVertexInputBindingDescription binding{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
    VkPipelineVertexInputStateCreateInfo vertices{};
    vertices.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    vertices.vertexBindingDescriptionCount = 1;
    vertices.pVertexBindingDescriptions = &binding;
    vertices.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size());
    vertices.pVertexAttributeDescriptions = attributes.data();

    VkPipelineInputAssemblyStateCreateInfo assembly{};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{};
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo raster{};
    raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    raster.lineWidth = 1.0f;
    VkPipelineMultisampleStateCreateInfo multisample{};
    multisample.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    VkPipelineDepthStencilStateCreateInfo depth{};
    depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    depth.depthTestEnable = VK_TRUE;
    depth.depthWriteEnable = permgen::state_value(pass, "ZWriteEnable", "TRUE") == "TRUE";
    depth.depthCompareOp = VK_COMPARE_OP_GREATER_OR_EQUAL;  // reversed depth, scene.fx's ZFunc
    VkPipelineColorBlendAttachmentState attachment{};
    attachment.blendEnable = permgen::state_value(pass, "AlphaBlendEnable", "FALSE") == "TRUE";
    attachment.srcColorBlendFactor = attachment.dstColorBlendFactor = VK_BLEND_FACTOR_ONE;
    attachment.srcAlphaBlendFactor = attachment.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    attachment.colorWriteMask = 15;
    VkPipelineColorBlendStateCreateInfo blend{};
    blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend.attachmentCount = 1;
    blend.pAttachments = &attachment;
    constexpr std::array dynamicStates{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR, VK_DYNAMIC_STATE_CULL_MODE,
                                       VK_DYNAMIC_STATE_FRONT_FACE};
    VkPipelineDynamicStateCreateInfo dynamic{};
    dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic.dynamicStateCount = static_cast<std::uint32_t>(dynamicStates.size());
    dynamic.pDynamicStates = dynamicStates.data();
    VkPipelineRenderingCreateInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
    rendering.colorAttachmentCount = 1;
    rendering.pColorAttachmentFormats = &colour;
    rendering.depthAttachmentFormat = depthFormat;

    const std::array stageInfos{stages[0].info, stages[1].info};
    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.pNext = &rendering;
    info.stageCount = static_cast<std::uint32_t>(stageInfos.size());
    info.pStages = stageInfos.data();
    info.pVertexInputState = &vertices;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &multisample;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = pipeline.layout;
    return vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline.handle);
}

}  // namespace

SurfacePipelines::SurfacePipelines(const headless::Device& device, VkFormat colour, VkFormat depth)
    : device_(device),
      colour_(colour),
      depth_(depth),
      pushDescriptors_(reinterpret_cast<PFN_vkCmdPushDescriptorSetKHR>(
          vkGetDeviceProcAddr(device.device(), "vkCmdPushDescriptorSetKHR"))) {}

SurfacePipelines::~SurfacePipelines() {
    for (const auto& [name, pipeline] : pipelines_) {
        vkDestroyPipeline(device_.device(), pipeline->handle, nullptr);
        vkDestroyPipelineLayout(device_.device(), pipeline->layout, nullptr);
        vkDestroyDescriptorSetLayout(device_.device(), pipeline->set, nullptr);
        for (VkSampler sampler : pipeline->samplers) vkDestroySampler(device_.device(), sampler, nullptr);
    }
}

Outcome<const SurfacePipeline*> SurfacePipelines::get(std::string_view name) {
    if (const auto known = pipelines_.find(name); known != pipelines_.end()) return known->second.get();
    const permgen::Technique* technique = permgen::find_technique(scene_effect::effect, name);
    if (technique == nullptr) return fail("scene.fx has no technique {}", name);

    SurfacePipeline& pipeline = *pipelines_.emplace(technique->name, std::make_unique<SurfacePipeline>()).first->second;
    pipeline.pass = &technique->passes[0];
    const VkDevice device = device_.device();
    std::array<Stage, 2> stages;
    VkResult made = createLayouts(device, pipeline);
    if (made == VK_SUCCESS) made = stages[0].load(device, pipeline.pass->vertex, VK_SHADER_STAGE_VERTEX_BIT);
    if (made == VK_SUCCESS) made = stages[1].load(device, pipeline.pass->pixel, VK_SHADER_STAGE_FRAGMENT_BIT);
    if (made == VK_SUCCESS) made = createPipeline(device, pipeline, stages, colour_, depth_);
    for (const Stage& stage : stages) vkDestroyShaderModule(device, stage.info.module, nullptr);
    if (made != VK_SUCCESS)
        return fail("the pipeline {} could not be made (VkResult {})", name, static_cast<int>(made));
    device_.setName(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<std::uint64_t>(pipeline.handle), name);
    return &pipeline;
}

void SurfacePipelines::push(VkCommandBuffer commands, const SurfacePipeline& pipeline,
                            const VkDescriptorBufferInfo& uniforms, const std::vector<BoundImage>& images) const {
    std::vector<VkDescriptorImageInfo> infos(pipeline.pass->live.size());
    std::vector<VkWriteDescriptorSet> writes;
    for (std::size_t i = 0; i < infos.size(); ++i) {
        const permgen::Resource& resource = *pipeline.pass->live[i];
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstBinding = resource.binding;
        write.descriptorCount = 1;
        write.descriptorType = descriptorType(resource);
        if (resource.kind == permgen::ResourceKind::UniformBuffer) {
            write.pBufferInfo = &uniforms;
        } else {
            for (const BoundImage& image : images)
                if (image.sampler == resource.name)
                    infos[i] = {pipeline.samplers[i], image.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
            write.pImageInfo = &infos[i];
        }
        writes.push_back(write);
    }
    pushDescriptors_(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.layout, 0,
                     static_cast<std::uint32_t>(writes.size()), writes.data());
}

}  // namespace tyndall::app

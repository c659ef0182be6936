#include "create_pipeline.h"

#include <array>

#include "shader_stages.h"
#include "states.h"

namespace tyndall {
namespace {

Result<void> checkFormats(const Gpu& gpu, const PassTarget& target, bool blends) {
    VkFormatProperties properties;
    for (const VkFormat colour : target.colours) {
        if (colour == VK_FORMAT_UNDEFINED) continue;
        const VkFormatFeatureFlags needed =
            blends ? VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT : VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT;
        vkGetPhysicalDeviceFormatProperties(gpu.physicalDevice, colour, &properties);
        if (!(properties.optimalTilingFeatures & needed))
            return unsupported("the device cannot " + std::string(blends ? "blend into" : "draw to") +
                               " the colour format " + formatName(colour) + "; use another one");
    }
    if (target.depth != VK_FORMAT_UNDEFINED) {
        vkGetPhysicalDeviceFormatProperties(gpu.physicalDevice, target.depth, &properties);
        if (!(properties.optimalTilingFeatures & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT))
            return unsupported("the device cannot use " + formatName(target.depth) +
                               " as a depth format; use another one");
    }
    return {};
}

}  // namespace

Result<VkPipeline> createPipeline(const Gpu& gpu, const PassLayout& layout, Shaders shaders, const PassTarget& target,
                                  std::span<const VkVertexInputAttributeDescription> attributes) {
    const permgen::Pass& pass = *layout.pass;
    const auto states = passStates(pass.states);
    if (!states) return tl::unexpected(states.error());
    if (auto checked = checkFormats(gpu, target, states->blend.blendEnable == VK_TRUE); !checked)
        return tl::unexpected(checked.error());
    ShaderStages stages(gpu);
    if (auto loaded = stages.load(pass, shaders); !loaded) return tl::unexpected(loaded.error());

    const VkVertexInputBindingDescription binding{0, 0, VK_VERTEX_INPUT_RATE_VERTEX};
    VkPipelineVertexInputStateCreateInfo vertexInput{};
    vertexInput.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    vertexInput.vertexBindingDescriptionCount = 1;
    vertexInput.pVertexBindingDescriptions = &binding;
    vertexInput.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size());
    vertexInput.pVertexAttributeDescriptions = attributes.data();

    VkPipelineInputAssemblyStateCreateInfo assembly{};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = target.topology;

    VkPipelineViewportStateCreateInfo viewport{};
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = 1;
    viewport.scissorCount = 1;

    VkPipelineRasterizationStateCreateInfo raster{};
    raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    raster.cullMode = states->cull;
    raster.frontFace = VK_FRONT_FACE_CLOCKWISE;
    raster.lineWidth = 1.0f;

    VkPipelineMultisampleStateCreateInfo multisample{};
    multisample.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;

    VkPipelineDepthStencilStateCreateInfo depth{};
    depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    depth.depthTestEnable = states->depthTest && target.depth != VK_FORMAT_UNDEFINED;
    depth.depthWriteEnable = states->depthWrite && depth.depthTestEnable;
    depth.depthCompareOp = states->depthCompare.value_or(target.compare);

    std::uint32_t colours = 0;
    for (std::uint32_t i = 0; i < target.colours.size(); ++i)
        if (target.colours[i] != VK_FORMAT_UNDEFINED) colours = i + 1;
    std::array<VkPipelineColorBlendAttachmentState, std::tuple_size_v<decltype(target.colours)>> blends{};
    blends.fill(states->blend);
    VkPipelineColorBlendStateCreateInfo blend{};
    blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend.attachmentCount = colours;
    blend.pAttachments = blends.data();

    constexpr std::array dynamicStates{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                       VK_DYNAMIC_STATE_VERTEX_INPUT_BINDING_STRIDE, VK_DYNAMIC_STATE_CULL_MODE,
                                       VK_DYNAMIC_STATE_FRONT_FACE};
    VkPipelineDynamicStateCreateInfo dynamic{};
    dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic.dynamicStateCount = static_cast<std::uint32_t>(dynamicStates.size()) - (target.dynamicCulling ? 0 : 2);
    dynamic.pDynamicStates = dynamicStates.data();

    VkPipelineRenderingCreateInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
    rendering.colorAttachmentCount = colours;
    rendering.pColorAttachmentFormats = target.colours.data();
    rendering.depthAttachmentFormat = target.depth;

    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.pNext = &rendering;
    info.stageCount = stages.count();
    info.pStages = stages.data();
    info.pVertexInputState = &vertexInput;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &multisample;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = layout.pipeline;
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult result = vkCreateGraphicsPipelines(gpu.device, gpu.pipelineCache, 1, &info, nullptr, &pipeline);
    if (result != VK_SUCCESS) return vulkanError("vkCreateGraphicsPipelines", result);
    return pipeline;
}

}  // namespace tyndall

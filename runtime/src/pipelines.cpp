#include "pipelines.h"

#include <array>

#include "shader_stages.h"
#include "states.h"

namespace tyndall {
namespace {

Result<void> checkFormats(const Gpu& gpu, const PipelineTarget& target, bool blends) {
    VkFormatProperties properties;
    if (target.colour != VK_FORMAT_UNDEFINED) {
        const VkFormatFeatureFlags needed =
            blends ? VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT : VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT;
        vkGetPhysicalDeviceFormatProperties(gpu.physicalDevice, target.colour, &properties);
        if (!(properties.optimalTilingFeatures & needed))
            return unsupported("the device cannot " + std::string(blends ? "blend into" : "draw to") +
                               " the colour format " + formatName(target.colour) + "; use another one");
    }
    if (target.depth != VK_FORMAT_UNDEFINED) {
        vkGetPhysicalDeviceFormatProperties(gpu.physicalDevice, target.depth, &properties);
        if (!(properties.optimalTilingFeatures & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT))
            return unsupported("the device cannot use " + formatName(target.depth) +
                               " as a depth format; use another one");
    }
    return {};
}

Result<std::vector<VkVertexInputAttributeDescription>> vertexAttributes(const permgen::Module& module,
                                                                        std::span<const VertexElement> elements) {
    std::vector<VkVertexInputAttributeDescription> attributes;
    for (const permgen::Attribute& attribute : module.attributes) {
        const VertexElement* found = nullptr;
        for (const VertexElement& element : elements)
            if (element.semantic == attribute.semantic) found = &element;
        if (!found)
            return invalidArgument("the vertex shader " + std::string(module.name) + " reads " +
                                   std::string(attribute.semantic) + ", which the vertices do not have");
        attributes.push_back({attribute.location, 0, found->format, found->offset});
    }
    return attributes;
}

Result<VkPipeline> createPipeline(const Gpu& gpu, const permgen::Pass& pass, Shaders shaders, const PassLayout& layout,
                                  const PipelineTarget& target, std::span<const VertexElement> elements) {
    const auto states = passStates(pass.states);
    if (!states) return tl::unexpected(states.error());
    if (auto checked = checkFormats(gpu, target, states->blend.blendEnable == VK_TRUE); !checked)
        return tl::unexpected(checked.error());
    if (!pass.vertex.module) return invalidArgument("the pass has no vertex shader; give it one");
    const auto attributes = vertexAttributes(*pass.vertex.module, elements);
    if (!attributes) return tl::unexpected(attributes.error());
    ShaderStages stages(gpu);
    if (auto loaded = stages.load(pass, shaders); !loaded) return tl::unexpected(loaded.error());

    const VkVertexInputBindingDescription binding{0, 0, VK_VERTEX_INPUT_RATE_VERTEX};
    VkPipelineVertexInputStateCreateInfo vertexInput{};
    vertexInput.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    vertexInput.vertexBindingDescriptionCount = 1;
    vertexInput.pVertexBindingDescriptions = &binding;
    vertexInput.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes->size());
    vertexInput.pVertexAttributeDescriptions = attributes->data();

    VkPipelineInputAssemblyStateCreateInfo assembly{};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;

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

    VkPipelineColorBlendStateCreateInfo blend{};
    blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend.attachmentCount = target.colour != VK_FORMAT_UNDEFINED ? 1 : 0;
    blend.pAttachments = &states->blend;

    constexpr std::array dynamicStates{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                       VK_DYNAMIC_STATE_VERTEX_INPUT_BINDING_STRIDE};
    VkPipelineDynamicStateCreateInfo dynamic{};
    dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic.dynamicStateCount = static_cast<std::uint32_t>(dynamicStates.size());
    dynamic.pDynamicStates = dynamicStates.data();

    VkPipelineRenderingCreateInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
    rendering.colorAttachmentCount = blend.attachmentCount;
    rendering.pColorAttachmentFormats = &target.colour;
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

}  // namespace

Result<Pipeline> pipelineFor(const Gpu& gpu, PipelineStore& store, const permgen::Effect& effect,
                             const permgen::Technique& technique, Shaders shaders, const PipelineTarget& target,
                             std::span<const VertexElement> elements, std::uint64_t& created) {
    if (technique.passes.size() != 1)
        return invalidArgument("the technique " + std::string(technique.name) + " has " +
                               std::to_string(technique.passes.size()) + " passes; the renderer draws one");
    const permgen::Pass& pass = technique.passes[0];
    if (const auto known = store.pipelines.find({&pass, target}); known != store.pipelines.end()) return known->second;

    auto layout = store.layouts.find(&pass);
    if (layout == store.layouts.end()) {
        auto made = createLayout(gpu, boundResources(effect, pass, shaders), technique.name);
        if (!made) return tl::unexpected(made.error());
        layout = store.layouts.emplace(&pass, std::move(*made)).first;
    }
    auto handle = createPipeline(gpu, pass, shaders, layout->second, target, elements);
    if (!handle) {
        Error error = handle.error();
        error.message = std::string(technique.name) + ": " + error.message;
        return tl::unexpected(std::move(error));
    }
    setName(gpu, VK_OBJECT_TYPE_PIPELINE, *handle, technique.name);
    ++created;
    return store.pipelines.emplace(std::pair(&pass, target), Pipeline{*handle, &layout->second}).first->second;
}

void destroyPipelines(const Gpu& gpu, PipelineStore& store) {
    for (auto& [key, pipeline] : store.pipelines) vkDestroyPipeline(gpu.device, pipeline.handle, nullptr);
    for (auto& [pass, layout] : store.layouts) destroyLayout(gpu, layout);
    store = {};
}

}  // namespace tyndall

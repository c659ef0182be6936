#include "pipelines.h"

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

const VertexElement* elementOf(const permgen::Attribute& attribute, std::span<const VertexElement> elements) {
    for (const VertexElement& element : elements)
        if (element.semantic == attribute.semantic) return &element;
    return nullptr;
}

Result<std::vector<VkVertexInputAttributeDescription>> vertexAttributes(const Gpu& gpu, const permgen::Module& module,
                                                                        std::span<const VertexElement> elements) {
    std::vector<VkVertexInputAttributeDescription> attributes;
    for (const permgen::Attribute& attribute : module.attributes) {
        const VertexElement* element = elementOf(attribute, elements);
        if (!element)
            return invalidArgument("the vertex shader " + std::string(module.name) + " reads " +
                                   std::string(attribute.semantic) + ", which the vertices do not have");
        VkFormatProperties properties;
        vkGetPhysicalDeviceFormatProperties(gpu.physicalDevice, element->format, &properties);
        if (!(properties.bufferFeatures & VK_FORMAT_FEATURE_VERTEX_BUFFER_BIT))
            return unsupported("the device cannot read vertices of " + formatName(element->format) +
                               "; use another format for " + std::string(attribute.semantic));
        attributes.push_back({attribute.location, 0, element->format, element->offset});
    }
    return attributes;
}

/// True where vertexAttributes() would give `attributes`.
bool madeOf(std::span<const VkVertexInputAttributeDescription> attributes, const permgen::Module& module,
            std::span<const VertexElement> elements) {
    for (std::size_t i = 0; i < attributes.size(); ++i) {
        const VertexElement* element = elementOf(module.attributes[i], elements);
        if (!element || element->format != attributes[i].format || element->offset != attributes[i].offset)
            return false;
    }
    return true;
}

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

/// How messages call the pass: by its technique, and by its number where that has several. Empty where it is
/// none of the effect's.
std::string passName(const permgen::Effect& effect, const permgen::Pass& pass) {
    for (const permgen::Technique& technique : effect.techniques)
        for (std::size_t i = 0; i < technique.passes.size(); ++i)
            if (&technique.passes[i] == &pass)
                return std::string(technique.name) +
                       (technique.passes.size() > 1 ? ", pass " + std::to_string(i) : std::string());
    return {};
}

tl::unexpected<Error> within(const std::string& name, Error error) {
    error.message = name + ": " + error.message;
    return tl::unexpected(std::move(error));
}

}  // namespace

Result<PassPipeline> pipelineFor(const Gpu& gpu, PipelineStore& store, const permgen::Effect& effect,
                                 const permgen::Pass& pass, Shaders shaders, const PassTarget& target,
                                 std::span<const VertexElement> elements, std::uint64_t& created) {
    const auto known = store.pipelines.find({&pass, target});
    if (known != store.pipelines.end())
        for (const PipelineStore::Entry& entry : known->second)
            if (madeOf(entry.attributes, *pass.vertex.module, elements)) return entry.pipeline;

    const std::string name = passName(effect, pass);
    if (name.empty())
        return invalidArgument("the pass is none of the effect " + std::string(effect.name) + "; give one of its own");
    if (!pass.vertex.module) return invalidArgument(name + ": the pass has no vertex shader; give it one");
    auto attributes = vertexAttributes(gpu, *pass.vertex.module, elements);
    if (!attributes) return within(name, attributes.error());
    auto layout = store.layouts.find(&pass);
    if (layout == store.layouts.end()) {
        auto made = createLayout(gpu, pass, boundResources(effect, pass, shaders), name);
        if (!made) return tl::unexpected(made.error());
        layout = store.layouts.emplace(&pass, std::move(*made)).first;
    }
    const auto handle = createPipeline(gpu, layout->second, shaders, target, *attributes);
    if (!handle) return within(name, handle.error());
    setName(gpu, VK_OBJECT_TYPE_PIPELINE, *handle, name);
    ++created;
    auto& entries = store.pipelines[{&pass, target}];
    return entries.emplace_back(PipelineStore::Entry{std::move(*attributes), {*handle, &layout->second}}).pipeline;
}

void destroyPipelines(const Gpu& gpu, PipelineStore& store) {
    for (auto& [key, entries] : store.pipelines)
        for (const PipelineStore::Entry& entry : entries) vkDestroyPipeline(gpu.device, entry.pipeline.handle, nullptr);
    for (auto& [pass, layout] : store.layouts) destroyLayout(gpu, layout);
    store = {};
}

}  // namespace tyndall

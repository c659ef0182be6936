#include "shader_stages.h"

namespace tyndall {

ShaderStages::~ShaderStages() {
    for (const VkPipelineShaderStageCreateInfo& stage : stages_)
        vkDestroyShaderModule(gpu_.device, stage.module, nullptr);
}

Result<void> ShaderStages::load(const permgen::Pass& pass, Shaders shaders) {
    if (pass.compute.module) return add(pass.compute, shaders, VK_SHADER_STAGE_COMPUTE_BIT);
    if (auto added = add(pass.vertex, shaders, VK_SHADER_STAGE_VERTEX_BIT); !added) return added;
    if (!pass.pixel.module) return {};
    return add(pass.pixel, shaders, VK_SHADER_STAGE_FRAGMENT_BIT);
}

Result<void> ShaderStages::add(const permgen::Shader& shader, Shaders shaders, VkShaderStageFlagBits stage) {
    const bool frozen = shaders == Shaders::Frozen;
    if (frozen && shader.frozen.empty())
        return invalidArgument(std::string(shader.module->name) +
                               " has no frozen module; compile its effect with permgen's --freeze");
    const std::span<const std::uint32_t> code = frozen ? shader.frozen : shader.module->code;
    VkShaderModuleCreateInfo moduleInfo{};
    moduleInfo.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    moduleInfo.codeSize = code.size_bytes();
    moduleInfo.pCode = code.data();

    VkPipelineShaderStageCreateInfo& info = stages_[count_];
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage;
    const VkResult result = vkCreateShaderModule(gpu_.device, &moduleInfo, nullptr, &info.module);
    if (result != VK_SUCCESS) return vulkanError("vkCreateShaderModule", result);
    setName(gpu_, VK_OBJECT_TYPE_SHADER_MODULE, info.module, shader.module->name);
    entries_[count_] = shader.module->entry;
    info.pName = entries_[count_].c_str();

    if (!frozen && !shader.constants.empty()) {
        Specialization& specialization = specializations_[count_];
        for (const permgen::Constant& constant : shader.constants) {
            const auto offset = static_cast<std::uint32_t>(specialization.values.size() * sizeof(std::uint32_t));
            specialization.entries.push_back({constant.id, offset, sizeof(std::uint32_t)});
            specialization.values.push_back(constant.bits);
        }
        specialization.info.mapEntryCount = static_cast<std::uint32_t>(specialization.entries.size());
        specialization.info.pMapEntries = specialization.entries.data();
        specialization.info.dataSize = specialization.values.size() * sizeof(std::uint32_t);
        specialization.info.pData = specialization.values.data();
        info.pSpecializationInfo = &specialization.info;
    }
    ++count_;
    return {};
}

}  // namespace tyndall

// A pass's shaders as pipeline stages.
#pragma once

#include <permgen/tables.h>

#include <array>
#include <vector>

#include "gpu_context.h"

namespace tyndall {

/// Holds the shader modules and specialization of one pipeline while it is created.
class ShaderStages {
public:
    explicit ShaderStages(const Gpu& gpu) : gpu_(gpu) {}
    ShaderStages(const ShaderStages&) = delete;
    ShaderStages& operator=(const ShaderStages&) = delete;
    ~ShaderStages();

    /// Call it once for each object. Errors: InvalidArgument if frozen modules are wanted and permgen made none.
    Result<void> load(const permgen::Pass& pass, Shaders shaders);

    std::uint32_t count() const { return count_; }
    const VkPipelineShaderStageCreateInfo* data() const { return stages_.data(); }

private:
    /// The data that VkSpecializationInfo points to.
    struct Specialization {
        VkSpecializationInfo info{};
        std::vector<VkSpecializationMapEntry> entries;
        std::vector<std::uint32_t> values;
    };

    Result<void> add(const permgen::Shader& shader, Shaders shaders, VkShaderStageFlagBits stage);

    const Gpu& gpu_;
    std::uint32_t count_ = 0;
    std::array<VkPipelineShaderStageCreateInfo, 2> stages_{};
    std::array<Specialization, 2> specializations_{};
    std::array<std::string, 2> entries_;
};

}  // namespace tyndall

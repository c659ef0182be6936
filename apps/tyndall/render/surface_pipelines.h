// The techniques of scene.fx as Vulkan pipelines, each with a layout of just the resources it reads.
#pragma once

#include <headless/device.h>
#include <permgen/tables.h>

#include <array>
#include <map>
#include <memory>
#include <string_view>
#include <vector>

#include "../outcome.h"

namespace tyndall::app {

/// A pass of scene.fx, ready to draw with.
struct SurfacePipeline {
    const permgen::Pass* pass = nullptr;
    VkDescriptorSetLayout set = VK_NULL_HANDLE;  ///< push descriptors
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkPipeline handle = VK_NULL_HANDLE;
    std::vector<VkSampler> samplers;  ///< in the order of pass->live; null for the uniform block
};

struct BoundImage {
    std::string_view sampler;
    VkImageView view;
};

class SurfacePipelines {
public:
    /// Draws into `colour` and `depth`; the device must outlive this.
    SurfacePipelines(const headless::Device& device, VkFormat colour, VkFormat depth);
    SurfacePipelines(const SurfacePipelines&) = delete;
    SurfacePipelines& operator=(const SurfacePipelines&) = delete;
    ~SurfacePipelines();

    /// Made on first use. `name` must be one of scene.fx.
    Outcome<const SurfacePipeline*> get(std::string_view name);

    /// Pushes the uniform block and, of `images`, those that the pass reads.
    void push(VkCommandBuffer commands, const SurfacePipeline& pipeline, const VkDescriptorBufferInfo& uniforms,
              const std::vector<BoundImage>& images) const;

    std::size_t count() const { return pipelines_.size(); }

private:
    const headless::Device& device_;
    VkFormat colour_, depth_;
    PFN_vkCmdPushDescriptorSetKHR pushDescriptors_ = nullptr;
    std::map<std::string_view, std::unique_ptr<SurfacePipeline>> pipelines_;
};

}  // namespace tyndall::app

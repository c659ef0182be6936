// What a pass binds: its live resources and nothing else.
#pragma once

#include <permgen/tables.h>

#include <array>
#include <span>
#include <vector>

#include "gpu_context.h"

namespace tyndall {

/// More than any pass may bind; the least that maxPushDescriptors can be (Vulkan 1.3, table 52).
constexpr std::size_t maxLiveResources = 32;

struct PassLayout {
    const permgen::Pass* pass = nullptr;
    VkDescriptorSetLayout set = VK_NULL_HANDLE;
    VkPipelineLayout pipeline = VK_NULL_HANDLE;
    std::vector<VkSampler> samplers;  ///< in the order of pass->live; null for a buffer
};

/// The layout of `pass` with push descriptors. Owns what it returns: destroyLayout().
Result<PassLayout> createLayout(const Gpu& gpu, const permgen::Pass& pass, std::string_view name);
void destroyLayout(const Gpu& gpu, PassLayout& layout);

/// An image for a sampler of that name.
struct NamedImage {
    std::string_view sampler;
    VkImageView view;
    VkImageLayout layout;
};

/// Pushes the uniform block (`uniforms`) and, of `images`, those that are live. Returns how many
/// descriptors that were. Errors: InvalidArgument where a live sampler has no image of its name.
Result<std::uint32_t> pushLive(const Gpu& gpu, VkCommandBuffer commands, const PassLayout& layout,
                               const VkDescriptorBufferInfo& uniforms, std::span<const NamedImage> images);

}  // namespace tyndall

// What a pass binds: its live resources and nothing else, unless its shaders are the shared module.
#pragma once

#include <permgen/tables.h>

#include <array>
#include <span>
#include <vector>

#include "gpu_context.h"

namespace tyndall {

/// More than any pass may bind; the least that maxPushDescriptors can be (Vulkan 1.3, table 52).
constexpr std::size_t maxBoundResources = 32;

struct PassLayout {
    VkDescriptorSetLayout set = VK_NULL_HANDLE;
    VkPipelineLayout pipeline = VK_NULL_HANDLE;
    std::vector<const permgen::Resource*> bound;
    std::vector<VkSampler> samplers;  ///< in the order of `bound`; null for a buffer
};

/// What `pass` binds: its live resources where its modules are frozen, all of the effect's where they are the
/// shared, specialized ones.
std::vector<const permgen::Resource*> boundResources(const permgen::Effect& effect, const permgen::Pass& pass,
                                                     Shaders shaders);

/// The layout of `bound` with push descriptors. Owns what it returns: destroyLayout().
Result<PassLayout> createLayout(const Gpu& gpu, std::vector<const permgen::Resource*> bound, std::string_view name);
void destroyLayout(const Gpu& gpu, PassLayout& layout);

bool binds(const PassLayout& layout, std::string_view resource);

/// An image for a sampler of that name.
struct NamedImage {
    std::string_view sampler;
    VkImageView view;
    VkImageLayout layout;
};

/// Pushes the uniform block (`uniforms`) and, of `images`, those that the layout binds. Returns how many
/// descriptors that were. Errors: InvalidArgument where a bound sampler has no image of its name.
Result<std::uint32_t> pushResources(const Gpu& gpu, VkCommandBuffer commands, const PassLayout& layout,
                                    const VkDescriptorBufferInfo& uniforms, std::span<const NamedImage> images);

}  // namespace tyndall

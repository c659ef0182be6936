// What a pass binds: its live resources and nothing else, unless its shaders are the shared module.
#pragma once

#include <permgen/tables.h>
#include <tyndall/pass_pipelines.h>

#include <array>
#include <span>
#include <vector>

#include "gpu_context.h"

namespace tyndall {

/// More than any pass may bind; the least that maxPushDescriptors can be (Vulkan 1.3, table 52).
constexpr std::size_t maxBoundResources = 32;

struct PassLayout {
    const permgen::Pass* pass = nullptr;
    VkDescriptorSetLayout set = VK_NULL_HANDLE;
    VkPipelineLayout pipeline = VK_NULL_HANDLE;
    std::vector<const permgen::Resource*> bound;
    std::vector<VkSampler> samplers;  ///< in the order of `bound`; null for a buffer
};

/// What `pass` binds: its live resources where its modules are frozen, all of the effect's where they are the
/// shared, specialized ones.
std::vector<const permgen::Resource*> boundResources(const permgen::Effect& effect, const permgen::Pass& pass,
                                                     Shaders shaders);

/// The layout of `bound` with push descriptors, for `pass`, which messages call `name`. Owns what it returns:
/// destroyLayout().
Result<PassLayout> createLayout(const Gpu& gpu, const permgen::Pass& pass, std::vector<const permgen::Resource*> bound,
                                std::string_view name);
void destroyLayout(const Gpu& gpu, PassLayout& layout);

bool binds(const PassLayout& layout, std::string_view resource);

/// What is pushed for resources that a pass binds, does not read and was not given.
struct StandIns {
    VkDescriptorBufferInfo buffer{};      ///< as long as any such block
    std::array<VkImageView, 5> images{};  ///< by permgen::ImageDimension
};

/// Pushes, of `buffers` and `images`, those that the layout binds. Returns how many descriptors that were.
/// Errors: InvalidArgument naming a bound resource that has neither a buffer or image of its name nor, where
/// the pass does not read it, one in `standIns`.
Result<std::uint32_t> pushResources(const Gpu& gpu, VkCommandBuffer commands, const PassLayout& layout,
                                    std::span<const NamedBuffer> buffers, std::span<const NamedImage> images,
                                    const StandIns& standIns = {});

}  // namespace tyndall

// The resources that a pass binds: only its live ones, unless its shaders are the shared module.
#pragma once

#include <permgen/tables.h>
#include <tyndall/pass_pipelines.h>

#include <array>
#include <map>
#include <span>
#include <vector>

#include "gpu_context.h"

namespace tyndall {

/// Maximum number of resources of a pass: the required minimum of maxPushDescriptors (Vulkan 1.3, table 52).
constexpr std::size_t maxBoundResources = 32;

struct PassLayout {
    const permgen::Pass* pass = nullptr;
    VkDescriptorSetLayout set = VK_NULL_HANDLE;
    VkPipelineLayout pipeline = VK_NULL_HANDLE;
    std::vector<const permgen::Resource*> bound;
    std::vector<VkSampler> samplers;  ///< in the order of `bound`; null for a buffer
};

/// The resources that `pass` binds: its live ones with frozen modules, all of the effect with shared, specialized ones.
std::vector<const permgen::Resource*> boundResources(const permgen::Effect& effect, const permgen::Pass& pass,
                                                     Shaders shaders);

/// The layout of `bound` with push descriptors, for `pass`, which messages call `name`. Owns what it returns:
/// destroyLayout().
Result<PassLayout> createLayout(const Gpu& gpu, const permgen::Pass& pass, std::vector<const permgen::Resource*> bound,
                                std::string_view name);
void destroyLayout(const Gpu& gpu, PassLayout& layout);

bool binds(const PassLayout& layout, std::string_view resource);

/// The descriptors for resources that a pass binds and does not read, if the caller gives none.
struct StandIns {
    VkDescriptorBufferInfo buffer{};         ///< as long as the longest such block
    std::array<VkImageView, 5> images{};     ///< by permgen::ImageDimension
    VkDescriptorBufferInfo storageBuffer{};  ///< as long as the longest element of such a buffer
    std::map<std::pair<permgen::ImageFormat, permgen::ImageDimension>, VkImageView> storageImages;

    /// Null if there is none for that resource.
    VkImageView storageImage(const permgen::Resource& resource) const;
};

/// Pushes those `buffers` and `images` that the layout binds. Returns the number of descriptors.
/// Errors: InvalidArgument naming a bound resource without a buffer or image of its name, and without a stand-in;
/// resources that the pass reads have no stand-in.
Result<std::uint32_t> pushResources(const Gpu& gpu, VkCommandBuffer commands, const PassLayout& layout,
                                    std::span<const NamedBuffer> buffers, std::span<const NamedImage> images,
                                    const StandIns& standIns = {});

}  // namespace tyndall

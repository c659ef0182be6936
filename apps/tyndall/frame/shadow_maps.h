// The lights' shadow maps on the device, drawn again only where they show something else by now.
#pragma once

#include <headless/image.h>
#include <tyndall/renderer.h>
#include <tyndall/shadow_cache.h>

#include <optional>
#include <span>
#include <vector>

#include "gpu_scene.h"
#include "view_scene.h"

namespace tyndall::app {

constexpr VkFormat shadowFormat = VK_FORMAT_D32_SFLOAT;

/// As many maps as one frame ever called for at once. A light that a frame does not call for keeps its map until
/// another light needs one.
class ShadowMaps {
public:
    /// From here on no map is called for, and each may be given to another light.
    void startFrame() { ++frame_; }

    /// Makes the maps of these lights, numbers into viewed.lights, show what stands in their volumes. Answers the
    /// milliseconds from submission to fence; 0 where every map showed it.
    Result<double> draw(const headless::Device& device, Renderer& renderer, const ViewedScene& viewed,
                         std::span<const std::size_t> lights, const GpuScene& gpu, std::uint32_t size);

    /// SHADER_READ_ONLY_OPTIMAL; null where this frame has not called for the light's map.
    const headless::Image* image(std::size_t light) const;
    VkImageView view(std::size_t light) const { return image(light) ? image(light)->view() : VK_NULL_HANDLE; }

    /// Maps on the device, called for or not.
    std::size_t count() const { return slots_.size(); }
    /// Device memory of what the maps were drawn with.
    VkDeviceSize frameDataBytes() const { return data_.memory(); }

private:
    struct Slot {
        headless::Image image;
        std::size_t light = 0;
        std::uint64_t frame = 0;  ///< that called for it last
    };
    Result<std::size_t> slotFor(const headless::Device& device, std::size_t light, std::uint32_t size);

    std::vector<Slot> slots_;
    std::vector<std::optional<std::size_t>> slotOf_;  ///< by light
    std::uint64_t frame_ = 1;
    std::uint32_t size_ = 0;
    ShadowCache cache_;
    FrameData data_;
};

}  // namespace tyndall::app

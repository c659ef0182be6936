// The lights' shadow maps on the device, drawn again only when their content has changed.
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

/// As many maps as the largest number that one frame needed. A light that needs no map in a frame keeps its map until
/// another light needs one.
class ShadowMaps {
public:
    /// Starts a frame: no map is needed yet, and each may be given to another light.
    void startFrame() { ++frame_; }

    /// Draws the outdated maps of these lights, indices into viewed.lights; with `hierarchies` also the shadow
    /// hierarchies that Method::Raycast reads. Returns the milliseconds from submission to fence; 0 if nothing was
    /// outdated.
    Result<double> draw(const headless::Device& device, Renderer& renderer, const ViewedScene& viewed,
                        std::span<const std::size_t> lights, const GpuScene& gpu, std::uint32_t size, bool hierarchies);

    /// SHADER_READ_ONLY_OPTIMAL; null if this frame does not need the light's map.
    const headless::Image* image(std::size_t light) const;
    VkImageView view(std::size_t light) const { return image(light) ? image(light)->view() : VK_NULL_HANDLE; }

    /// Null if this frame does not need the light's map, or it has no hierarchy.
    VkImageView hierarchy(std::size_t light) const;

    /// Maps on the device, needed or not.
    std::size_t count() const { return slots_.size(); }
    /// Device memory of the data for drawing the maps.
    VkDeviceSize frameDataBytes() const { return data_.memory(); }

private:
    struct Slot {
        headless::Image image, hierarchy;
        bool hierarchyDrawn = false;
        std::size_t light = 0;
        std::uint64_t frame = 0;  ///< the last one that needed it
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

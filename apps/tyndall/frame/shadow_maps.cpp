#include "shadow_maps.h"

#include <headless/commands.h>

#include <algorithm>

namespace tyndall::app {
namespace {

Result<void> fitHierarchy(const headless::Device& device, headless::Image& image, std::uint32_t mapSize) {
    if (image.handle()) return {};
    const std::uint32_t side = shadowHierarchySide(mapSize);
    auto made =
        headless::Image::create(device, {.extent = {side, side},
                                         .format = shadowHierarchyFormat,
                                         .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                                         .name = "shadow hierarchy",
                                         .levels = shadowHierarchyLevels(mapSize)});
    if (!made) return passOn(made.error(), "the shadow hierarchy");
    image = std::move(*made);
    return {};
}

}  // namespace

const headless::Image* ShadowMaps::image(std::size_t light) const {
    if (light >= slotOf_.size() || !slotOf_[light]) return nullptr;
    const Slot& slot = slots_[*slotOf_[light]];
    return slot.frame == frame_ ? &slot.image : nullptr;
}

VkImageView ShadowMaps::hierarchy(std::size_t light) const {
    if (!image(light)) return VK_NULL_HANDLE;
    const Slot& slot = slots_[*slotOf_[light]];
    return slot.hierarchyDrawn ? slot.hierarchy.view() : VK_NULL_HANDLE;
}

Result<std::size_t> ShadowMaps::slotFor(const headless::Device& device, std::size_t light, std::uint32_t size) {
    if (slotOf_[light]) return *slotOf_[light];
    const auto oldest = std::ranges::min_element(slots_, {}, &Slot::frame);
    if (oldest != slots_.end() && oldest->frame != frame_) {
        slotOf_[oldest->light].reset();
        cache_.invalidate(oldest->light);
        oldest->light = light;
        return *(slotOf_[light] = static_cast<std::size_t>(oldest - slots_.begin()));
    }
    auto image = headless::Image::create(device, {.extent = {size, size},
                                                  .format = shadowFormat,
                                                  .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT |
                                                           VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                                                  .name = "shadow map"});
    if (!image) return passOn(image.error(), fmt::format("--shadow-size {}", size));
    Slot& slot = slots_.emplace_back();
    slot.image = std::move(*image);
    slot.light = light;
    slot.frame = frame_;
    return *(slotOf_[light] = slots_.size() - 1);
}

Result<double> ShadowMaps::draw(const headless::Device& device, Renderer& renderer, const ViewedScene& viewed,
                                std::span<const std::size_t> lights, const GpuScene& gpu, std::uint32_t size,
                                bool hierarchies) {
    if (size != size_) {
        slots_.clear();
        slotOf_.clear();
        cache_.invalidate();
        size_ = size;
    }
    slotOf_.resize(viewed.lights.size());
    // Lights that have a map keep it; only other maps are reassigned.
    for (const std::size_t light : lights)
        if (slotOf_[light]) slots_[*slotOf_[light]].frame = frame_;
    struct Stale {
        std::size_t light, slot;
        std::vector<Occluder> occluders;
        std::vector<ShadowCaster> casters;
    };
    std::vector<Stale> stale;
    std::vector<std::size_t> withoutHierarchy;  // slots
    std::vector<Occluder> occluders;
    std::vector<ShadowCaster> casters;
    for (const std::size_t light : lights) {
        const auto slot = slotFor(device, light, size);
        if (!slot) return tl::unexpected(slot.error());
        slots_[*slot].frame = frame_;
        occluders.clear();
        casters.clear();
        for (const std::size_t instance : viewed.instancesInLight[light]) {
            occluders.push_back(occluderOf(gpu, viewed.scene, instance));
            casters.push_back(shadowCaster(occluders.back()));
        }
        if (cache_.stale(light, viewed.lights[light], casters, size))
            stale.push_back({light, *slot, occluders, casters});
        Slot& used = slots_[*slot];
        if (!stale.empty() && stale.back().slot == *slot) used.hierarchyDrawn = false;
        if (hierarchies && !used.hierarchyDrawn) {
            if (auto made = fitHierarchy(device, used.hierarchy, size); !made) return tl::unexpected(made.error());
            withoutHierarchy.push_back(*slot);
        }
    }
    if (stale.empty() && withoutHierarchy.empty()) return 0.0;
    // The data of earlier maps is not needed any more; an empty plan frees its memory.
    if (auto reset = renderer.upload(data_, Plan{}); !reset) return passOn(reset.error(), "the shadow maps");
    const auto time = headless::submitAndWait(device, [&](VkCommandBuffer commands) -> Result<void> {
        for (const Stale& map : stale) {
            const headless::Image& image = slots_[map.slot].image;
            headless::transition(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
            auto drawn = renderer.recordShadowMap(commands, data_, viewed.lights[map.light], map.occluders,
                                                  image.view(), shadowFormat, size);
            if (!drawn) return drawn;
            headless::transition(commands, image, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        }
        for (const std::size_t slot : withoutHierarchy) {
            const headless::Image& image = slots_[slot].hierarchy;
            const VkImageView whole = image.view();
            auto drawn = renderer.recordShadowHierarchy(
                commands, data_, slots_[slot].image.view(), size,
                {image.handle(), image.levels().empty() ? std::span(&whole, 1) : std::span(image.levels())});
            if (!drawn) return drawn;
        }
        return {};
    });
    if (!time) return passOn(time.error(), "the shadow maps");
    for (const std::size_t slot : withoutHierarchy) slots_[slot].hierarchyDrawn = true;
    for (const Stale& map : stale) cache_.drawn(map.light, viewed.lights[map.light], map.casters, size);
    return *time;
}

}  // namespace tyndall::app

// A 2D image with one layer and one sample, with memory of its own.
#pragma once

#include <headless/device.h>

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace headless {

/// Bytes of one texel as copied to a buffer (the depth aspect of a depth format); 0 for a format that
/// this library does not know: block-compressed, multi-planar and rare packed formats.
std::uint32_t texelBytes(VkFormat format);

/// The aspect that views and copies use: depth for depth formats, else colour.
VkImageAspectFlags imageAspect(VkFormat format);

struct ImageInfo {
    VkExtent2D extent{};
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkImageUsageFlags usage = 0;
    std::string_view name = {};
    std::uint32_t levels = 1;  ///< mip levels
};

class Image {
public:
    /// Errors: InvalidArgument where a side is 0 or longer than the device's limit; UnsupportedDevice where
    /// the device does not offer the format for that usage; Vulkan.
    static Result<Image> create(const Device& device, const ImageInfo& info);
    Image() = default;
    Image(Image&& other) noexcept;
    Image& operator=(Image&& other) noexcept;
    ~Image();

    VkImage handle() const { return image_; }
    /// A view of the whole image; null if the usage allows no view.
    VkImageView view() const { return view_; }
    /// A view of each mip level; empty for an image with one level.
    const std::vector<VkImageView>& levels() const { return levels_; }
    VkExtent2D extent() const { return extent_; }
    VkFormat format() const { return format_; }
    VkImageAspectFlags aspect() const { return imageAspect(format_); }

private:
    std::shared_ptr<DeviceCore> core_;
    VkImage image_ = VK_NULL_HANDLE;
    VkImageView view_ = VK_NULL_HANDLE;
    std::vector<VkImageView> levels_;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    VkDeviceSize allocated_ = 0;
    VkExtent2D extent_{};
    VkFormat format_ = VK_FORMAT_UNDEFINED;
};

/// Fills the image's first level with `texels` (rows top to bottom, no padding) and leaves it in `layout`. Waits.
/// The image's usage must have TRANSFER_DST. Errors: InvalidArgument if the number of bytes is not the
/// image's, Vulkan.
Result<void> upload(const Device& device, const Image& image, std::span<const std::byte> texels,
                    VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);

/// The texels of the image's first level, rows top to bottom, no padding. Expects it in `layout` and leaves it there.
/// Waits. The image's usage must have TRANSFER_SRC. Errors: InvalidArgument, Vulkan.
Result<std::vector<std::byte>> readback(const Device& device, const Image& image, VkImageLayout layout);

}  // namespace headless

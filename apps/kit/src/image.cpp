#include <headless/image.h>

#include <utility>

#include "device_core.h"
#include "memory.h"

namespace headless {
namespace {

constexpr VkImageUsageFlags viewableUsage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                            VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                            VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;

Result<void> checkInfo(const Device& device, const ImageInfo& info) {
    const std::uint32_t limit = device.properties().limits.maxImageDimension2D;
    const std::string size = std::to_string(info.extent.width) + "x" + std::to_string(info.extent.height);
    if (info.extent.width == 0 || info.extent.height == 0 || info.extent.width > limit || info.extent.height > limit)
        return tl::unexpected(Error{ErrorCode::InvalidArgument,
                                    "an image of " + size + " was requested; each side must be from 1 to " +
                                        std::to_string(limit) + " texels on this device",
                                    VK_SUCCESS});
    VkImageFormatProperties properties;
    const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
        device.physicalDevice(), info.format, VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL, info.usage, 0, &properties);
    if (result == VK_ERROR_FORMAT_NOT_SUPPORTED)
        return tl::unexpected(Error{
            ErrorCode::UnsupportedDevice,
            "the device does not offer image format " + std::to_string(info.format) + " (as VkFormat) for that usage",
            result});
    if (result != VK_SUCCESS) return vulkanError("vkGetPhysicalDeviceImageFormatProperties", result);
    return {};
}

/// Of `count` mip levels from `first` on.
Result<VkImageView> createView(const Device& device, VkImage image, const ImageInfo& info, std::uint32_t first,
                               std::uint32_t count) {
    VkImageViewCreateInfo create{};
    create.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    create.image = image;
    create.viewType = VK_IMAGE_VIEW_TYPE_2D;
    create.format = info.format;
    create.subresourceRange = {imageAspect(info.format), first, count, 0, 1};
    VkImageView view = VK_NULL_HANDLE;
    const VkResult result = vkCreateImageView(device.device(), &create, nullptr, &view);
    if (result != VK_SUCCESS) return vulkanError("vkCreateImageView", result);
    device.setName(VK_OBJECT_TYPE_IMAGE_VIEW, reinterpret_cast<std::uint64_t>(view), info.name);
    return view;
}

}  // namespace

Result<Image> Image::create(const Device& device, const ImageInfo& info) {
    if (auto checked = checkInfo(device, info); !checked) return tl::unexpected(checked.error());
    Image image;
    image.core_ = device.core();
    image.extent_ = info.extent;
    image.format_ = info.format;

    VkImageCreateInfo create{};
    create.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    create.imageType = VK_IMAGE_TYPE_2D;
    create.format = info.format;
    create.extent = {info.extent.width, info.extent.height, 1};
    create.mipLevels = info.levels;
    create.arrayLayers = 1;
    create.samples = VK_SAMPLE_COUNT_1_BIT;
    create.tiling = VK_IMAGE_TILING_OPTIMAL;
    create.usage = info.usage;
    VkDevice handle = device.device();
    VkResult result = vkCreateImage(handle, &create, nullptr, &image.image_);
    if (result != VK_SUCCESS) return vulkanError("vkCreateImage", result);

    VkMemoryRequirements requirements;
    vkGetImageMemoryRequirements(handle, image.image_, &requirements);
    auto memory = allocate(*image.core_, requirements, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    if (!memory) return tl::unexpected(memory.error());
    image.memory_ = memory->memory;
    image.allocated_ = memory->size;
    result = vkBindImageMemory(handle, image.image_, image.memory_, 0);
    if (result != VK_SUCCESS) return vulkanError("vkBindImageMemory", result);
    device.setName(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(image.image_), info.name);

    if (info.usage & viewableUsage) {
        const auto view = createView(device, image.image_, info, 0, info.levels);
        if (!view) return tl::unexpected(view.error());
        image.view_ = *view;
        for (std::uint32_t level = 0; info.levels > 1 && level < info.levels; ++level) {
            const auto one = createView(device, image.image_, info, level, 1);
            if (!one) return tl::unexpected(one.error());
            image.levels_.push_back(*one);
        }
    }
    return image;
}

Image::Image(Image&& other) noexcept {
    *this = std::move(other);
}

Image& Image::operator=(Image&& other) noexcept {
    std::swap(core_, other.core_);
    std::swap(image_, other.image_);
    std::swap(view_, other.view_);
    std::swap(levels_, other.levels_);
    std::swap(memory_, other.memory_);
    std::swap(allocated_, other.allocated_);
    std::swap(extent_, other.extent_);
    std::swap(format_, other.format_);
    return *this;
}

Image::~Image() {
    if (!core_) return;
    for (const VkImageView level : levels_) vkDestroyImageView(core_->device, level, nullptr);
    vkDestroyImageView(core_->device, view_, nullptr);
    vkDestroyImage(core_->device, image_, nullptr);
    release(*core_, memory_, allocated_);
}

}  // namespace headless

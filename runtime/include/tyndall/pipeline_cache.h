// The format of a pipeline cache file: the data of vkGetPipelineCacheData() behind a header that identifies its device.
//
// Drivers must check Vulkan's own header only, and some check nothing: truncated or changed bytes may crash them. Pass
// a file's bytes through openPipelineCache() before a driver reads them:
//
//   const auto data = openPipelineCache(bytes, properties);  // on an error: report it, and start with an empty cache
//   info.initialDataSize = data->size();                     // of a VkPipelineCacheCreateInfo
//   info.pInitialData = data->data();
//
// The checksum detects accidents, not attacks: keep the file where only its owner can write. Pure functions on bytes;
// safe from any thread.
#pragma once

#include <tyndall/result.h>
#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <span>
#include <vector>

namespace tyndall {

/// Bytes that sealPipelineCache() puts before the data.
inline constexpr std::size_t pipelineCacheSeal = 80;

/// `data` from vkGetPipelineCacheData() on the device of those properties, behind a seal. The same data, device and
/// driver give the same bytes on every machine.
std::vector<std::byte> sealPipelineCache(std::span<const std::byte> data, const VkPhysicalDeviceProperties& device);

/// The data within `sealed`; they start at a multiple of 16 bytes from its beginning.
/// Errors: InvalidArgument with the reason: not a sealed cache, another version of the seal, truncated, followed by
/// more bytes, changed, made by a device or driver other than `device`, or data whose Vulkan header
/// (VkPipelineCacheHeaderVersionOne) does not match `device`.
Result<std::span<const std::byte>> openPipelineCache(std::span<const std::byte> sealed,
                                                     const VkPhysicalDeviceProperties& device);

/// Whether `bytes` begin like a sealed cache, or are a beginning of one; true for no bytes. Do not overwrite a file
/// that holds anything else: another program made it.
bool isSealedPipelineCache(std::span<const std::byte> bytes);

}  // namespace tyndall

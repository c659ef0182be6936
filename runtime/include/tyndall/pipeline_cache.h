// A pipeline cache as a file holds it: what vkGetPipelineCacheData() gave, behind a header that tells who made it.
//
// Drivers are required to look at Vulkan's own header alone, and some look at nothing: bytes that were cut short
// or changed on disk may crash them. So a file's bytes go through openPipelineCache() before a driver sees them:
//
//   const auto data = openPipelineCache(bytes, properties);  // on an error: say so, and start with an empty cache
//   info.initialDataSize = data->size();                     // of a VkPipelineCacheCreateInfo
//   info.pInitialData = data->data();
//
// The checksum guards against accidents, not against people: keep the file where only its owner can write.
// Pure functions on bytes; safe from any thread.
#pragma once

#include <tyndall/result.h>
#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <span>
#include <vector>

namespace tyndall {

/// Bytes that sealPipelineCache() puts before the data.
inline constexpr std::size_t pipelineCacheSeal = 80;

/// `data` as vkGetPipelineCacheData() gave it on the device of those properties, behind a seal. The same bytes for
/// the same data, device and driver, on every machine.
std::vector<std::byte> sealPipelineCache(std::span<const std::byte> data, const VkPhysicalDeviceProperties& device);

/// What was sealed: a part of `sealed`, which starts at a multiple of 16 bytes from its beginning.
/// Errors: InvalidArgument, with what is wrong: not a sealed cache, of another version of the seal, cut short or
/// followed by more bytes, changed, of a device or a driver other than `device`, or sealed from data that are no
/// pipeline cache of `device` by Vulkan's own header (VkPipelineCacheHeaderVersionOne).
Result<std::span<const std::byte>> openPipelineCache(std::span<const std::byte> sealed,
                                                     const VkPhysicalDeviceProperties& device);

/// Whether `bytes` begin as sealed caches do, as far as they go, whatever follows: true for none at all. A file
/// that holds anything else is somebody else's, and not to be written over.
bool isSealedPipelineCache(std::span<const std::byte> bytes);

}  // namespace tyndall

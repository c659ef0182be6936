// The fields are those that A. Kapoulkine's "Robust pipeline cache serialization" (zeux.io, 2019) asks for: the meaning
// of the data may change with the driver's version, and with the size of pointers if one driver serves 32-bit and
// 64-bit programs, while pipelineCacheUUID stays the same.
#include <tyndall/pipeline_cache.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

#include "gpu_context.h"

// Only this file includes it, so the installed library does not need it.
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace tyndall {
namespace {

/// Like PNG's: a byte above 127 and both kinds of line end, which a transfer as text would change.
constexpr std::array<std::uint8_t, 8> magic{0x89, 'T', 'P', 'C', '\r', '\n', 0x1a, '\n'};
constexpr std::uint32_t sealVersion = 1;

// Offsets in bytes; every number has its lowest byte first.
constexpr std::size_t versionAt = 8, pointerAt = 12, vendorAt = 16, deviceAt = 20, driverAt = 24, sizeAt = 32,
                      uuidAt = 40, checksumAt = 64;
static_assert(uuidAt + VK_UUID_SIZE <= checksumAt && checksumAt + 16 == pipelineCacheSeal);

// Vulkan's own header: headerSize, headerVersion, vendorID, deviceID, pipelineCacheUUID (Vulkan 1.3, 10.7.3).
constexpr std::size_t vulkanHeader = 32, vulkanVersionAt = 4, vulkanVendorAt = 8, vulkanDeviceAt = 12,
                      vulkanUuidAt = 16;

template <class Number>
void write(std::span<std::byte> bytes, std::size_t at, Number value) {
    for (std::size_t i = 0; i < sizeof value; ++i) bytes[at + i] = static_cast<std::byte>(value >> (8 * i));
}

template <class Number>
Number read(std::span<const std::byte> bytes, std::size_t at) {
    Number value = 0;
    for (std::size_t i = 0; i < sizeof value; ++i) value |= std::to_integer<Number>(bytes[at + i]) << (8 * i);
    return value;
}

/// 128 bits of XXH3 over all but the checksum itself, in xxHash's canonical order (highest byte first).
XXH128_canonical_t checksum(std::span<const std::byte> sealed) {
    const std::span<const std::byte> data = sealed.subspan(pipelineCacheSeal);
    const XXH128_hash_t ofData = XXH3_128bits(data.data(), data.size());
    // The data's hash is appended to the header and hashed with it: this gives one sum over both without copying the
    // data.
    std::array<std::byte, checksumAt + sizeof(XXH128_canonical_t)> header;
    std::copy_n(sealed.begin(), checksumAt, header.begin());
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, ofData);
    std::copy_n(std::as_bytes(std::span(canonical.digest)).begin(), sizeof canonical, header.begin() + checksumAt);
    XXH128_canonicalFromHash(&canonical, XXH3_128bits(header.data(), header.size()));
    return canonical;
}

bool hasUuid(std::span<const std::byte> bytes, std::size_t at, const VkPhysicalDeviceProperties& device) {
    return std::ranges::equal(bytes.subspan(at, VK_UUID_SIZE), std::as_bytes(std::span(device.pipelineCacheUUID)));
}

/// An error if another device, driver or kind of program made the seal.
Result<void> checkMaker(std::span<const std::byte> sealed, const VkPhysicalDeviceProperties& device) {
    if (read<std::uint32_t>(sealed, vendorAt) != device.vendorID ||
        read<std::uint32_t>(sealed, deviceAt) != device.deviceID)
        return invalidArgument("the pipeline cache is of another device than " + std::string(device.deviceName));
    if (read<std::uint32_t>(sealed, driverAt) != device.driverVersion || !hasUuid(sealed, uuidAt, device))
        return invalidArgument("the pipeline cache is of another version of the driver of " +
                               std::string(device.deviceName));
    if (read<std::uint32_t>(sealed, pointerAt) != sizeof(void*))
        return invalidArgument("the pipeline cache is of a program with pointers of another size");
    return {};
}

/// An error if the data's own header is not Vulkan's for `device`.
Result<void> checkVulkanHeader(std::span<const std::byte> data, const VkPhysicalDeviceProperties& device) {
    if (data.size() < vulkanHeader)
        return invalidArgument("the pipeline cache holds " + std::to_string(data.size()) +
                               " bytes, fewer than Vulkan's header has");
    if (read<std::uint32_t>(data, 0) != vulkanHeader ||
        read<std::uint32_t>(data, vulkanVersionAt) != VK_PIPELINE_CACHE_HEADER_VERSION_ONE)
        return invalidArgument("the pipeline cache's data begin with a header that is not version one of Vulkan's");
    if (read<std::uint32_t>(data, vulkanVendorAt) != device.vendorID ||
        read<std::uint32_t>(data, vulkanDeviceAt) != device.deviceID || !hasUuid(data, vulkanUuidAt, device))
        return invalidArgument("the pipeline cache's data are of another device or driver than " +
                               std::string(device.deviceName));
    return {};
}

}  // namespace

std::vector<std::byte> sealPipelineCache(std::span<const std::byte> data, const VkPhysicalDeviceProperties& device) {
    std::vector<std::byte> sealed(pipelineCacheSeal + data.size());
    const std::span<std::byte> bytes(sealed);
    std::ranges::copy(std::as_bytes(std::span(magic)), bytes.begin());
    write(bytes, versionAt, sealVersion);
    write(bytes, pointerAt, static_cast<std::uint32_t>(sizeof(void*)));
    write(bytes, vendorAt, device.vendorID);
    write(bytes, deviceAt, device.deviceID);
    write(bytes, driverAt, device.driverVersion);
    write(bytes, sizeAt, static_cast<std::uint64_t>(data.size()));
    std::ranges::copy(std::as_bytes(std::span(device.pipelineCacheUUID)), bytes.begin() + uuidAt);
    std::ranges::copy(data, bytes.begin() + pipelineCacheSeal);
    const XXH128_canonical_t sum = checksum(sealed);
    std::ranges::copy(std::as_bytes(std::span(sum.digest)), bytes.begin() + checksumAt);
    return sealed;
}

bool isSealedPipelineCache(std::span<const std::byte> bytes) {
    const std::size_t size = std::min(bytes.size(), magic.size());
    return std::ranges::equal(bytes.first(size), std::as_bytes(std::span(magic)).first(size));
}

Result<std::span<const std::byte>> openPipelineCache(std::span<const std::byte> sealed,
                                                     const VkPhysicalDeviceProperties& device) {
    if (!isSealedPipelineCache(sealed)) return invalidArgument("the bytes are not a sealed pipeline cache");
    // The version comes first: another version may define all other fields differently.
    if (sealed.size() >= versionAt + 4 && read<std::uint32_t>(sealed, versionAt) != sealVersion)
        return invalidArgument("the pipeline cache has version " +
                               std::to_string(read<std::uint32_t>(sealed, versionAt)) + " of its format, not " +
                               std::to_string(sealVersion));
    if (sealed.size() < pipelineCacheSeal)
        return invalidArgument("the pipeline cache is cut short: it ends within its header");
    const auto data = sealed.subspan(pipelineCacheSeal);
    const auto size = read<std::uint64_t>(sealed, sizeAt);
    if (data.size() < size)
        return invalidArgument("the pipeline cache is cut short: " + std::to_string(data.size()) + " of " +
                               std::to_string(size) + " bytes are there");
    if (data.size() > size)
        return invalidArgument("the pipeline cache is followed by " + std::to_string(data.size() - size) +
                               " bytes that are not its own");
    const XXH128_canonical_t sum = checksum(sealed);
    if (!std::ranges::equal(sealed.subspan(checksumAt, sizeof sum), std::as_bytes(std::span(sum.digest))))
        return invalidArgument("the pipeline cache is corrupt: its checksum does not fit");
    if (auto checked = checkMaker(sealed, device); !checked) return tl::unexpected(checked.error());
    if (auto checked = checkVulkanHeader(data, device); !checked) return tl::unexpected(checked.error());
    return data;
}

}  // namespace tyndall

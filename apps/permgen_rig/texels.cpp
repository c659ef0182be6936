#include "texels.h"

#include <cstdint>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace tyndall::rig {
namespace {

template <class Stored, class Decode>
std::vector<float> decodeEach(std::span<const std::byte> bytes, const Decode& decode) {
    std::vector<float> values(bytes.size() / sizeof(Stored));
    for (std::size_t i = 0; i < values.size(); ++i) {
        Stored stored;
        std::memcpy(&stored, bytes.data() + i * sizeof stored, sizeof stored);
        values[i] = decode(stored);
    }
    return values;
}

}  // namespace

std::vector<float> decodeTexels(std::span<const std::byte> bytes, VkFormat format) {
    if (format == VK_FORMAT_R16G16B16A16_SFLOAT)
        return decodeEach<std::uint16_t>(bytes, [](std::uint16_t half) { return glm::unpackHalf1x16(half); });
    if (format == VK_FORMAT_R8G8B8A8_UNORM)
        return decodeEach<std::uint8_t>(bytes, [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0f; });
    return decodeEach<float>(bytes, [](float value) { return value; });
}

}  // namespace tyndall::rig

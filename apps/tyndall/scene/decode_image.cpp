#include "decode_image.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

namespace tyndall::app {
namespace {

constexpr std::uint32_t longestImageSide = 16384;
constexpr std::uint64_t maxImageTexels = std::uint64_t{1} << 26;

std::uint32_t bigEndian(const unsigned char* bytes, int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i) value = value << 8 | bytes[i];
    return value;
}

/// Width and height as a PNG or JPEG header states them, before anything of that size is allocated.
std::optional<std::pair<std::uint32_t, std::uint32_t>> statedSize(const unsigned char* bytes, std::size_t size) {
    static constexpr unsigned char png[] = {0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A};
    if (size >= 24 && std::memcmp(bytes, png, sizeof png) == 0)
        return std::pair{bigEndian(bytes + 16, 4), bigEndian(bytes + 20, 4)};
    if (size < 4 || bytes[0] != 0xFF || bytes[1] != 0xD8) return std::nullopt;
    for (std::size_t at = 2; at + 9 <= size && bytes[at] == 0xFF;) {
        const unsigned char marker = bytes[at + 1];
        if (marker == 0xFF) {  // fill byte
            ++at;
            continue;
        }
        const bool frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
        if (frame) return std::pair{bigEndian(bytes + at + 7, 2), bigEndian(bytes + at + 5, 2)};
        at += 2 + bigEndian(bytes + at + 2, 2);
    }
    return std::nullopt;
}

}  // namespace

bool keepEncoded(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                 int size, void*) {
    image->image.assign(bytes, bytes + (size > 0 ? size : 0));
    image->as_is = true;
    return true;
}

Result<tinygltf::Image> decodeImage(const tinygltf::Image& encoded, std::size_t index) {
    const std::vector<unsigned char>& bytes = encoded.image;
    const auto stated = statedSize(bytes.data(), bytes.size());
    if (!stated) return fail("image {} is neither PNG nor JPEG; export the textures as one of these", index);
    if (stated->first > longestImageSide || stated->second > longestImageSide ||
        std::uint64_t{stated->first} * stated->second > maxImageTexels)
        return fail("image {} is {}x{} texels; at most {} a side and {} in all are read", index, stated->first,
                    stated->second, longestImageSide, maxImageTexels);
    tinygltf::Image decoded;
    std::string reason, warning;
    try {
        if (tinygltf::LoadImageData(&decoded, static_cast<int>(index), &reason, &warning, 0, 0, bytes.data(),
                                    static_cast<int>(bytes.size()), nullptr))
            return decoded;
    } catch (const std::bad_alloc&) {
        return fail("image {} needs too much memory; shrink it", index);
    }
    return fail("image {} cannot be decoded; save it again as PNG or JPEG", index);
}

}  // namespace tyndall::app

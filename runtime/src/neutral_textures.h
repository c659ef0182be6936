// Textures of one texel that change nothing: for lights that lack a texture of a forced technique, and for samplers
// that a specialized module declares and does not read.
#pragma once

#include <permgen/tables.h>

#include <array>
#include <map>
#include <utility>

#include "gpu_context.h"

namespace tyndall {

struct NeutralTexture {
    VkImage image = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
};

enum class Neutral : std::size_t {
    White,     ///< a cookie that lets all light through; noise of product 1
    NoShadow,  ///< a reversed shadow map with nothing in it
    White1d,
    White3d,
    WhiteCube,
};

struct NeutralTextures {
    std::array<NeutralTexture, 5> textures;  ///< by Neutral
    /// Storage images, which no shader reads or writes: Vulkan wants one where a module only declares it.
    std::map<std::pair<permgen::ImageFormat, permgen::ImageDimension>, NeutralTexture> storage;
};

/// The white texture of that dimension, which must not be None.
Neutral whiteTexture(permgen::ImageDimension dimension);

/// The texture, made on first use (`created` then grows by one).
Result<const NeutralTexture*> neutralTexture(const Gpu& gpu, NeutralTextures& textures, Neutral which,
                                             std::uint64_t& created);

/// The storage image of one texel with that format and dimension, made on first use (`created` then grows by one).
Result<const NeutralTexture*> neutralStorage(const Gpu& gpu, NeutralTextures& textures, permgen::ImageFormat format,
                                             permgen::ImageDimension dimension, std::uint64_t& created);

/// Records the filling of every texture that was made, outside of rendering; leaves them in
/// SHADER_READ_ONLY_OPTIMAL, storage images in GENERAL. Repeating it costs less than tracking which submissions ran.
void recordNeutralFill(VkCommandBuffer commands, const NeutralTextures& textures);

void destroyNeutralTextures(const Gpu& gpu, NeutralTextures& textures);

}  // namespace tyndall

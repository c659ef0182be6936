// The device that the tests draw on: Mesa's lavapipe with validation and synchronization validation, and the Renderers
// on it.
#pragma once

#include <gtest/gtest.h>
#include <headless/device.h>
#include <headless/image.h>
#include <tyndall/renderer.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "texture.h"

namespace tyndall::test {

/// An effect with one technique in place of all techniques.
struct StandIn {
    std::vector<permgen::Technique> techniques;
    permgen::Effect effect;
    std::optional<Renderer> renderer;
};

struct Gpu {
    headless::Device device;
    Renderer frozen;  // after the device, so that they are destroyed first
    Renderer specialized;
    std::map<std::pair<std::string, Shaders>, std::unique_ptr<StandIn>> standIns;

    /// A Renderer that draws everything with the technique of that name. It is for techniques that plan() does not
    /// know: an effect may declare more than the terms need.
    Renderer& rendererFor(std::string_view technique, Shaders shaders);
};

/// The process's one Gpu, made on first use. It ends with the test program.
Gpu& gpu();

/// Fails the test on any message of the validation layers.
class GpuTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;
};

/// The value, or an exception that ends the test with the error's sentence.
template <class T>
T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    if constexpr (!std::is_void_v<T>) return std::move(*result);
}

/// A float image of the texture: one channel as R32, two as RG32, three and four as RGBA32; `depth` stores one
/// channel as D32. In SHADER_READ_ONLY_OPTIMAL, or `layout`.
headless::Image uploadTexture(const Texture& texture, bool depth = false,
                              VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);

/// The texels of a D32 image in that layout, as stored.
Texture downloadDepth(const headless::Image& image, VkImageLayout layout);

}  // namespace tyndall::test

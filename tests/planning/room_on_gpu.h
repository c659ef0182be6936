// A room's textures and surfaces on the device, and pictures of its shafts.
#pragma once

#include <headless/buffer.h>
#include <headless/image.h>

#include "draw.h"
#include "room.h"

namespace tyndall::test {

class RoomOnGpu {
public:
    explicit RoomOnGpu(const Room& room);

    struct Shown {
        Picture picture;            ///< radiance
        RendererCounters counters;  ///< of this picture
        std::uint64_t fragments = 0;
    };
    /// `textures` replace the room's own, if not empty.
    Shown draw(const Plan& plan, std::span<const LightTextures> textures = {}, Renderer& renderer = gpu().frozen) const;

    std::span<const LightTextures> textures() const { return views_; }
    /// The light's shadow map, as stored. It must have one.
    Texture shadowMap(std::size_t light) const;

private:
    void drawShadowMaps(const Room& room);

    std::vector<headless::Image> images_;
    std::vector<std::size_t> maps_;  ///< by light: its shadow map among the images
    std::vector<LightTextures> views_;
    headless::Image depth_, sum_, colour_;
};

/// A new one that has made nothing yet.
Renderer freshRenderer();

}  // namespace tyndall::test

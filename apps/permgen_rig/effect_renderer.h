// Draws an effect's techniques with a fixture's resources, off screen.
#pragma once

#include <headless/buffer.h>
#include <headless/device.h>
#include <headless/image.h>
#include <permgen/tables.h>
#include <rig/image.h>
#include <tyndall/pass_pipelines.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "constants.h"
#include "fixture.h"
#include "geometry.h"
#include "textures.h"

namespace tyndall::rig {

/// The resource whose content is changed; empty: none.
using Variation = std::string_view;

class EffectRenderer {
public:
    /// Finds all errors of effect and fixture: the fixture must give all resources that the effect's
    /// techniques read. `effect` must outlive it.
    static Result<std::unique_ptr<EffectRenderer>> create(const headless::Device& device, const permgen::Effect& effect,
                                                          const Fixture& fixture);

    /// The target after the technique's first `passes` passes; further targets are below the first. With
    /// Shaders::Specialized all of the fixture's resources are bound, live or not.
    Result<Image> draw(const permgen::Technique& technique, std::size_t passes, Shaders shaders,
                       Variation variation = {});

    /// Whether draw() has a variation of that resource.
    bool canVary(std::string_view resource) const;
    /// Constants that the fixture leaves at 0.
    const std::vector<std::string>& unsetConstants() const { return constants_.unset; }

private:
    struct Block {
        headless::Buffer usual, other;
        bool varies = false;
    };
    struct Texture {
        headless::Image usual, other;
    };
    struct Stream {
        headless::Buffer vertices;
        std::vector<VertexElement> elements;
        std::uint32_t stride = 0;
    };
    struct Targets;

    EffectRenderer(const headless::Device& device, const permgen::Effect& effect, const Fixture& fixture)
        : device_(device), effect_(effect), fixture_(fixture) {}
    Result<void> makeBlocks();
    Result<void> makeTextures();
    Result<void> makeGeometry();
    Result<void> makePipelines();
    Result<Targets> makeTargets(const permgen::Technique& technique) const;
    Result<void> record(VkCommandBuffer commands, const Targets& targets, const permgen::Technique& technique,
                        std::size_t passes, Shaders shaders, Variation variation);
    Result<void> recordPass(VkCommandBuffer commands, const Targets& targets, PassPipelines& pipelines,
                            const permgen::Pass& pass, Variation variation);
    void recordDraw(VkCommandBuffer commands, const Stream& stream) const;
    Result<Image> readTargets(const Targets& targets) const;

    const headless::Device& device_;
    const permgen::Effect& effect_;
    Fixture fixture_;
    Constants constants_;
    std::map<std::string, Block, std::less<>> blocks_;
    std::map<std::string, Texture, std::less<>> textures_;
    headless::Buffer indices_;
    std::uint32_t indexCount_ = 0;
    std::map<const permgen::Module*, Stream> streams_;
    std::unique_ptr<PassPipelines> frozen_, specialized_;
};

}  // namespace tyndall::rig

// Shadow maps that are drawn only when stale, with only the needed occluders, equal those that are always drawn with
// all.
#include <gtest/gtest.h>
#include <headless/buffer.h>
#include <tyndall/shadow_cache.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <iterator>
#include <random>

#include "record_scene.h"

namespace tyndall::test {
namespace {

constexpr std::uint32_t side = 64;

class RecordShadowCache : public GpuTest {
protected:
    RecordShadowCache() {
        triangle.vertices = vertices.handle();
        triangle.indices = indices.handle();
        triangle.indexCount = 3;
        light.fov = {0.9, 0.5};
        light.nearPlane = 0.5;
        light.farPlane = 10.0;
    }

    Occluder placed(const glm::dmat4& worldFromMesh) const {
        Occluder occluder = triangle;
        occluder.worldFromMesh = worldFromMesh;
        return occluder;
    }

    std::vector<float> draw(std::span<const Occluder> occluders) {
        FrameData frame;
        run([&](VkCommandBuffer commands) {
            headless::transition(commands, map, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
            auto drawn =
                gpu().frozen.recordShadowMap(commands, frame, light, occluders, map.view(), map.format(), side);
            headless::transition(commands, map, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
            return drawn;
        });
        return texels<float>(map, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    }

    static headless::Buffer buffer(std::span<const std::byte> bytes, VkBufferUsageFlags usage) {
        return must(headless::Buffer::create(gpu().device, bytes, usage));
    }

    static constexpr std::array<float, 9> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
    static constexpr std::array<std::uint32_t, 3> order{0, 1, 2};
    static constexpr MeshBounds bounds{{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}};
    headless::Buffer vertices = buffer(std::as_bytes(std::span(corners)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    headless::Buffer indices = buffer(std::as_bytes(std::span(order)), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    headless::Image map = makeImage({side, side}, VK_FORMAT_D32_SFLOAT,
                                    VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT, "map");
    Occluder triangle;
    Light light;
};

TEST_F(RecordShadowCache, OccludersLeftOutLeaveNoMark) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&](double max) { return glm::dvec3(unit(random), unit(random), unit(random)) * max; };
    int left = 0, drawn = 0;
    for (int round = 0; round < 300; ++round) {
        const glm::dmat4 lightFromMesh =
            glm::scale(glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -5) + vector(6.0)),
                                   3.0 * unit(random), vector(1.0)),
                       vector(4.0));
        // Every third round is far from the origin, where doubles are coarse.
        light.worldFromLight = glm::rotate(glm::translate(glm::dmat4(1.0), round % 3 == 0 ? vector(1e6) : vector(1.0)),
                                           3.0 * unit(random), vector(1.0));
        const Occluder occluder = placed(light.worldFromLight * lightFromMesh);
        if (mayShade(light, occluder.worldFromMesh, bounds)) {
            ++drawn;
            continue;
        }
        ++left;
        for (const float depth : draw(std::span(&occluder, 1))) ASSERT_EQ(depth, 0.0f) << "round " << round;
    }
    EXPECT_GT(left, 50);
    EXPECT_GT(drawn, 50);
}

TEST_F(RecordShadowCache, EverythingThatIsDrawnTellsCastersApart) {
    const auto numbered = [](std::uint64_t number) { return std::bit_cast<VkBuffer>(number); };
    const Occluder occluder{numbered(7), 64, 32, numbered(8), 128, 300, glm::dmat4(1.0)};
    const std::vector<std::function<void(Occluder&)>> changes = {
        [&](Occluder& o) { o.vertices = numbered(9); }, [](Occluder& o) { o.vertexOffset += 4; },
        [](Occluder& o) { o.vertexStride += 4; },       [&](Occluder& o) { o.indices = numbered(7); },
        [](Occluder& o) { o.indexOffset += 4; },        [](Occluder& o) { o.indexCount -= 3; }};
    for (std::size_t change = 0; change < changes.size(); ++change) {
        Occluder other = occluder;
        changes[change](other);
        EXPECT_NE(shadowCaster(other).geometry, shadowCaster(occluder).geometry) << "change " << change;
        EXPECT_EQ(shadowCaster(other).worldFromMesh, occluder.worldFromMesh);
    }
    Occluder nothing = occluder;
    nothing.indexCount = 0;
    EXPECT_EQ(shadowCaster(nothing).geometry, ShadowCaster{}.geometry);
}

TEST_F(RecordShadowCache, AMapIsDrawnOncePerMove) {
    // Two hundred frames: the occluder crosses the light's pyramid from frame 50 on, 1 m a frame; another one before it
    // never moves.
    const Occluder standing = placed(glm::translate(glm::dmat4(1.0), {-0.5, -0.5, -3.0}));
    ShadowCache cache;
    const std::uint64_t before = gpu().frozen.counters().shadowMapsDrawn;
    std::vector<float> kept;
    int within = 0;
    std::uint64_t again = 0;  // drawn every time, for comparison
    for (int frame = 0; frame < 200; ++frame) {
        const double x = frame < 50 ? -20.0 : std::min(frame - 70.0, 20.0);
        std::vector<Occluder> occluders;
        for (const Occluder& each : {standing, placed(glm::translate(glm::dmat4(1.0), {x, 0.0, -5.0}))})
            if (mayShade(light, each.worldFromMesh, bounds)) occluders.push_back(each);
        within += occluders.size() == 2;
        std::vector<ShadowCaster> casters;
        std::ranges::transform(occluders, std::back_inserter(casters), shadowCaster);
        if (cache.stale(0, light, casters, side)) {
            kept = draw(occluders);
            cache.drawn(0, light, casters, side);
        }
        if (frame % 25 == 0 || occluders.size() == 2) {
            const std::uint64_t counted = gpu().frozen.counters().shadowMapsDrawn;
            EXPECT_TRUE(draw(occluders) == kept) << "frame " << frame;
            again += gpu().frozen.counters().shadowMapsDrawn - counted;
        }
    }
    // At 5 m the pyramid reaches 5 * tan(0.45) = 2.42 m to each side, and the triangle from x to x + 1: x from -3 to 2.
    EXPECT_EQ(within, 6);
    // Once at first, once for each place within, once when it has left.
    EXPECT_EQ(gpu().frozen.counters().shadowMapsDrawn - before - again, 1u + 6u + 1u);
}

}  // namespace
}  // namespace tyndall::test

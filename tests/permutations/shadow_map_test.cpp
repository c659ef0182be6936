// The runtime's shadow map: its position, its depths, and shafts drawn with it against the oracle.
#include <headless/buffer.h>
#include <headless/commands.h>

#include <array>
#include <cmath>

#include "draw.h"
#include "permutation.h"

namespace tyndall::test {
namespace {

class ShadowMapTest : public GpuTest {};

constexpr int kSize = 96;

// In the light's own space, metres: slanted and off-centre, without a symmetry that could hide a flipped map.
const std::array<glm::dvec3, 3> kTriangle{glm::dvec3(-0.5, -0.1, -1.6), glm::dvec3(0.1, 0.4, -2.2),
                                          glm::dvec3(0.25, -0.2, -1.4)};

Texture drawTriangle(const Light& light) {
    std::vector<float> positions;
    for (const glm::dvec3& corner : kTriangle)
        for (int i = 0; i < 3; ++i) positions.push_back(static_cast<float>(corner[i]));
    const std::array<std::uint32_t, 3> order{0, 1, 2};
    Gpu& g = gpu();
    const auto vertices = must(
        headless::Buffer::create(g.device, std::as_bytes(std::span(positions)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT));
    const auto indices =
        must(headless::Buffer::create(g.device, std::as_bytes(std::span(order)), VK_BUFFER_USAGE_INDEX_BUFFER_BIT));
    Occluder occluder;
    occluder.vertices = vertices.handle();
    occluder.indices = indices.handle();
    occluder.indexCount = 3;
    occluder.worldFromMesh = light.worldFromLight;

    headless::ImageInfo info;
    info.extent = {kSize, kSize};
    info.format = VK_FORMAT_D32_SFLOAT;
    info.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    const headless::Image map = must(headless::Image::create(g.device, info));
    FrameData frame;
    must(g.frozen.upload(frame, Plan{}));
    must(headless::submitAndWait(g.device, [&](VkCommandBuffer commands) -> Result<void> {
        headless::transition(commands, map, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
        return g.frozen.recordShadowMap(commands, frame, light, std::span(&occluder, 1), map.view(), map.format(),
                                        kSize);
    }));
    return downloadDepth(map, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
}

// The ray through a point of the map, for one metre along the axis: u right along +X, v down along -Y.
glm::dvec3 mapRay(const Light& light, double x, double y) {
    return {(2.0 * x / kSize - 1.0) * std::tan(0.5 * light.fov.x),
            (1.0 - 2.0 * y / kSize) * std::tan(0.5 * light.fov.y), -1.0};
}

// 0 outside, 1 inside, 2 within a hundredth of a texel of an edge: vertices snap to 1/256 of one.
int covers(const Light& light, double x, double y) {
    bool all = true, none = false;
    for (const double dx : {-0.01, 0.0, 0.01})
        for (const double dy : {-0.01, 0.0, 0.01}) {
            const glm::dvec3 ray = mapRay(light, x + dx, y + dy);
            std::array<bool, 3> left{};
            for (std::size_t i = 0; i < 3; ++i)
                left[i] = glm::dot(glm::cross(kTriangle[i], kTriangle[(i + 1) % 3]), ray) > 0.0;
            const bool inside = left[0] == left[1] && left[1] == left[2];
            all = all && inside;
            none = none || inside;
        }
    return all ? 1 : none ? 2 : 0;
}

TEST_F(ShadowMapTest, HoldsReversedDepthWhereTheOccluderStands) {
    const Light light = sideView().light;
    const Texture map = drawTriangle(light);
    const glm::dvec3 normal = glm::cross(kTriangle[1] - kTriangle[0], kTriangle[2] - kTriangle[0]);
    int inside = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const int covered = covers(light, x + 0.5, y + 0.5);
            if (covered == 2) continue;
            if (covered == 0) {
                ASSERT_EQ(map.at(x, y), 0.0f) << x << ", " << y;
                continue;
            }
            ++inside;
            const double axis = glm::dot(normal, kTriangle[0]) / glm::dot(normal, mapRay(light, x + 0.5, y + 0.5));
            // The plane equation of a depth up to 1, as for attributes in the oracle: 72 e X L / area2, here for
            // L = 57, area2 = 1400 and X = 96 texels, and a dozen roundings before it.
            const double slack = kFloatEps * (72.0 * 96.0 * 57.0 / 1400.0 + 12.0);
            ASSERT_NEAR(map.at(x, y), storedShadowDepth(light, axis), slack) << x << ", " << y;
        }
    EXPECT_GT(inside, 500);
}

TEST_F(ShadowMapTest, ShaftsThroughItMatchTheOracle) {
    for (const TermSet terms : allTermSets)
        if (terms.contains(Term::Shadow)) {
            Shot shot = withTerms(sideView(), terms);
            shot.slices = 24;
            shot.shadowMap = drawTriangle(shot.light);  // as stored
            const OracleImage expected = oracle(shot), open = oracle(withTerms(shot, terms.without(Term::Shadow)));
            const Drawing drawing = draw(shot);
            EXPECT_EQ(whyOutside(drawing.sum, drawing.plan.scale, allowedBy(expected)), "");
            // The triangle really takes light away.
            double shadowed = 0.0, lit = 0.0;
            for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
                shadowed += expected.pixels[i].rgba[0].mid();
                lit += open.pixels[i].rgba[0].mid();
            }
            EXPECT_LT(shadowed, 0.95 * lit);
        }
}

}  // namespace
}  // namespace tyndall::test

// Passes of an unrelated effect, drawn with the runtime's public pipelines.
#include <headless/buffer.h>
#include <painting.fx.h>
#include <tyndall/pass_pipelines.h>
#include <tyndall/rendering.h>

#include "record_scene.h"

namespace tyndall::test {
namespace {

constexpr VkFormat kFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr std::array<VertexElement, 1> kElements{{{"POSITION0", 0, VK_FORMAT_R32G32_SFLOAT}}};
constexpr Rgba kPaint{0.25f, 0.5f, 1.0f, 2.0f};
constexpr PassTarget kTarget{.colours = {kFormat}};

const permgen::Pass& pass(std::string_view technique, std::size_t index = 0) {
    return permgen::find_technique(painting::effect, technique)->passes[index];
}

template <class Value>
headless::Buffer buffer(const Value& value, VkBufferUsageFlags usage) {
    return must(headless::Buffer::create(gpu().device, std::as_bytes(std::span(&value, 1)), usage));
}

class PassPipelinesTest : public GpuTest, public testing::WithParamInterface<Shaders> {
protected:
    PassPipelinesTest() {
        DeviceContext context{gpu().device.physicalDevice(), gpu().device.device()};
        context.shaders = GetParam();
        pipelines.emplace(must(PassPipelines::create(context, painting::effect)));
        fill(picture, std::vector<Rgba>(1, {1.0f, 0.5f, 0.25f, 0.125f}), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    }

    Result<std::uint32_t> push(VkCommandBuffer commands, const PassPipeline& pipeline) {
        const std::array<NamedBuffer, 2> buffers{
            {{"Paint", {paint.handle(), 0, 16}}, {"Placing", {placing.handle(), 0, 16}}}};
        const std::array<NamedImage, 1> images{{{"Picture", picture.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}}};
        return pipelines->push(commands, pipeline, buffers, images);
    }

    /// Draws the passes one after the other into black targets, and returns the targets.
    std::vector<std::vector<Rgba>> draw(const std::vector<const permgen::Pass*>& passes,
                                        const PassTarget& target = kTarget,
                                        const std::function<void(VkCommandBuffer)>& dynamicState = {}) {
        std::vector<headless::Image> images;
        std::vector<VkRenderingAttachmentInfo> attachments;
        for (const VkFormat format : target.colours) {
            if (format == VK_FORMAT_UNDEFINED) continue;
            images.push_back(makeImage({4, 4}, format, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, "painting"));
            VkRenderingAttachmentInfo attachment{};
            attachment.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
            attachment.imageView = images.back().view();
            attachment.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
            attachment.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
            attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
            attachments.push_back(attachment);
        }
        headless::Image depth;
        VkRenderingAttachmentInfo depthAttachment{};
        if (target.depth != VK_FORMAT_UNDEFINED) {
            depth = makeImage({4, 4}, target.depth, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, "depth");
            depthAttachment = attachments.front();
            depthAttachment.imageView = depth.view();
            depthAttachment.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
            depthAttachment.clearValue.depthStencil.depth = 0.75f;
        }
        std::vector<PassPipeline> ready;
        for (const permgen::Pass* one : passes) ready.push_back(must(pipelines->get(*one, target, kElements)));
        run([&](VkCommandBuffer commands) -> Result<void> {
            for (const headless::Image& image : images)
                headless::transition(commands, image, VK_IMAGE_LAYOUT_UNDEFINED,
                                     VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
            if (depth.handle())
                headless::transition(commands, depth, VK_IMAGE_LAYOUT_UNDEFINED,
                                     VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
            pipelines->recordNeutralResources(commands);
            beginRendering(commands, {4, 4}, attachments, depth.handle() ? &depthAttachment : nullptr);
            if (dynamicState) dynamicState(commands);
            const VkBuffer vertices = triangle.handle();
            const VkDeviceSize offset = 0, stride = sizeof(glm::vec2);
            vkCmdBindVertexBuffers2(commands, 0, 1, &vertices, &offset, nullptr, &stride);
            Result<void> done;
            for (const PassPipeline& pipeline : ready) {
                vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.handle);
                const auto pushed = push(commands, pipeline);
                if (!pushed) done = tl::unexpected(pushed.error());
                if (pushed) vkCmdDraw(commands, 3, 1, 0, 0);
            }
            vkCmdEndRendering(commands);
            return done;
        });
        std::vector<std::vector<Rgba>> drawn;
        for (const headless::Image& image : images)
            drawn.push_back(texels<Rgba>(image, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL));
        return drawn;
    }

    std::optional<PassPipelines> pipelines;
    headless::Image picture = makeImage({1, 1}, kFormat, VK_IMAGE_USAGE_SAMPLED_BIT, "picture");
    headless::Buffer paint = buffer(kPaint, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    // Half size about the origin: 2x2 pixels in the middle of the four by four, except the triangle's tip.
    headless::Buffer placing = buffer(Rgba{0.5f, 0.5f, 0.0f, 0.0f}, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    headless::Buffer triangle =
        buffer(std::array{glm::vec2(-1, -1), glm::vec2(3, -1), glm::vec2(-1, 3)}, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
};

INSTANTIATE_TEST_SUITE_P(Painting, PassPipelinesTest, testing::Values(Shaders::Frozen, Shaders::Specialized),
                         [](const auto& shaders) {
                             return shaders.param == Shaders::Frozen ? "Frozen" : "Specialized";
                         });

TEST_P(PassPipelinesTest, PassesDrawOneAfterTheOtherWithTheirOwnStatesAxesAndBlocks) {
    const auto drawn = draw({&pass("layered"), &pass("layered", 1)})[0];
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            // The triangle's half-size copy: corners (1, 1), (5, 1), (1, 5) in pixels; diagonal x + y = 6.
            const bool inside = x >= 1 && y >= 1;
            const Rgba picked{1.0f, 0.5f, 0.25f, 0.125f};
            for (std::size_t c = 0; c < 4; ++c) {
                const float expected = inside ? kPaint[c] * 0.5f + kPaint[c] * 2.0f * picked[c] : 0.0f;
                if (x + y + 1 >= 6) continue;
                EXPECT_EQ(drawn[static_cast<std::size_t>(y * 4 + x)][c], expected) << x << ", " << y;
            }
        }
    EXPECT_EQ(pipelines->count(), 2u);
}

TEST_P(PassPipelinesTest, ReadsSaysWhatIsLive) {
    const PassPipeline glaze = must(pipelines->get(pass("layered", 1), kTarget, kElements));
    EXPECT_TRUE(reads(glaze, "Paint") && reads(glaze, "Placing") && reads(glaze, "Picture"));
    EXPECT_FALSE(reads(glaze, "Sky") || reads(glaze, "Fog") || reads(glaze, "Ramp") || reads(glaze, "nothing"));
    EXPECT_FALSE(reads(must(pipelines->get(pass("still"), kTarget, kElements)), "Placing"));
}

TEST_P(PassPipelinesTest, EveryColourTargetIsDrawn) {
    const auto drawn = draw({&pass("both")}, {.colours = {kFormat, kFormat}});
    ASSERT_EQ(drawn.size(), 2u);
    for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_EQ(drawn[0][5][c], kPaint[c]);
        EXPECT_EQ(drawn[1][5][c], 2.0f * kPaint[c]);
    }
}

TEST_P(PassPipelinesTest, CullingIsThePassesOrDynamic) {
    const Rgba black{};
    // Clockwise in the picture, y down: what the pass culls.
    EXPECT_EQ(draw({&pass("culled")})[0][5], black);
    const PassTarget dynamic{.colours = {kFormat}, .dynamicCulling = true};
    const auto culling = [](VkCullModeFlags mode) {
        return [mode](VkCommandBuffer commands) {
            vkCmdSetCullMode(commands, mode);
            vkCmdSetFrontFace(commands, VK_FRONT_FACE_CLOCKWISE);
        };
    };
    EXPECT_EQ(draw({&pass("culled")}, dynamic, culling(VK_CULL_MODE_BACK_BIT))[0][5], kPaint);
    EXPECT_EQ(draw({&pass("still")}, dynamic, culling(VK_CULL_MODE_FRONT_BIT))[0][5], black);
}

TEST_P(PassPipelinesTest, DepthIsComparedAsThePassSaysOrElseAsTheTargetDoes) {
    const Rgba black{};
    PassTarget target{.colours = {kFormat}, .depth = VK_FORMAT_D32_SFLOAT, .compare = VK_COMPARE_OP_GREATER};
    EXPECT_EQ(draw({&pass("plain")}, target)[0][5], black) << "0.5 is not greater than 0.75";
    EXPECT_EQ(draw({&pass("nearer")}, target)[0][5], kPaint) << "but less";
    target.compare = VK_COMPARE_OP_LESS;
    EXPECT_EQ(draw({&pass("plain")}, target)[0][5], kPaint);
    // A depth write hides later draws at the same depth; without a write they show.
    const Rgba once = kPaint;
    const auto glazed = [&](std::string_view first) {
        return draw({&pass(first), &pass("nearer_glaze")}, target)[0][5];
    };
    EXPECT_EQ(glazed("plain"), once);
    EXPECT_EQ(glazed("nearer"), (Rgba{2 * once[0], 2 * once[1], 2 * once[2], 2 * once[3]}));
}

TEST_P(PassPipelinesTest, APipelineIsMadeOnceForEachTargetAndLayout) {
    const auto make = [&](const PassTarget& target, std::span<const VertexElement> elements) {
        return must(pipelines->get(pass("still"), target, elements)).handle;
    };
    const VkPipeline first = make(kTarget, kElements);
    EXPECT_EQ(make(kTarget, kElements), first);
    const std::array<VertexElement, 2> more{
        {{"TEXCOORD0", 0, VK_FORMAT_R32G32_SFLOAT}, {"POSITION0", 0, VK_FORMAT_R32G32_SFLOAT}}};
    EXPECT_EQ(make(kTarget, more), first) << "an element that is not read makes no difference";
    EXPECT_EQ(pipelines->count(), 1u);
    const std::array<VertexElement, 1> elsewhere{{{"POSITION0", 8, VK_FORMAT_R32G32_SFLOAT}}};
    EXPECT_NE(make(kTarget, elsewhere), first);
    EXPECT_NE(make({.colours = {kFormat}, .topology = VK_PRIMITIVE_TOPOLOGY_LINE_LIST}, kElements), first);
    EXPECT_NE(make({.colours = {VK_FORMAT_R16G16B16A16_SFLOAT}}, kElements), first);
    EXPECT_EQ(pipelines->count(), 4u);
}

TEST_P(PassPipelinesTest, SaysWhatIsMissing) {
    const auto expectError = [](const auto& result, ErrorCode code, std::string_view says) {
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, code);
        EXPECT_NE(result.error().message.find(says), std::string::npos) << result.error().message;
    };
    const std::array<VertexElement, 1> normals{{{"NORMAL0", 0, VK_FORMAT_R32G32_SFLOAT}}};
    expectError(pipelines->get(pass("layered", 1), kTarget, normals), ErrorCode::InvalidArgument,
                "layered, pass 1: the vertex shader vs_main reads POSITION0, which the vertices do not have");
    const permgen::Pass copy = pass("still");
    expectError(pipelines->get(copy, kTarget, kElements), ErrorCode::InvalidArgument, "none of the effect painting");
    expectError(pipelines->get(pass("still"), {.colours = {VK_FORMAT_D32_SFLOAT}}, kElements),
                ErrorCode::UnsupportedDevice, "still: the device cannot draw to the colour format VkFormat 126");
    expectError(pipelines->get(pass("still"), {.depth = VK_FORMAT_R8_UNORM}, kElements), ErrorCode::UnsupportedDevice,
                "as a depth format");
    const std::array<VertexElement, 1> compressed{{{"POSITION0", 0, VK_FORMAT_BC1_RGB_UNORM_BLOCK}}};
    expectError(pipelines->get(pass("still"), kTarget, compressed), ErrorCode::UnsupportedDevice, "for POSITION0");

    const PassPipeline glaze = must(pipelines->get(pass("layered", 1), kTarget, kElements));
    run([&](VkCommandBuffer commands) -> Result<void> {
        const std::array<NamedBuffer, 2> buffers{
            {{"Paint", {paint.handle(), 0, 16}}, {"Placing", {placing.handle(), 0, 16}}}};
        expectError(pipelines->push(commands, glaze, buffers, {}), ErrorCode::InvalidArgument,
                    "the sampler Picture has no image to read");
        const NamedImage image{"Picture", picture.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        expectError(pipelines->push(commands, glaze, std::span(buffers).first(1), std::span(&image, 1)),
                    ErrorCode::InvalidArgument, "the uniform block Placing has no buffer to read");
        return {};
    });
    EXPECT_FALSE(PassPipelines::create({}, painting::effect));
}

}  // namespace
}  // namespace tyndall::test

// Wrong arguments and missing features: an error names them, before any call to the device.
#include <gtest/gtest.h>
#include <headless/buffer.h>

#include <limits>

#include "record_scene.h"

namespace tyndall::test {
namespace {

/// A frame that can be recorded; each test breaks one thing.
struct Frame {
    Stage stage;
    std::vector<Light> lights{lamp()};
    Plan plan;
    FrameData data;
    std::vector<LightTextures> textures{LightTextures{}};
    ShaftTargets targets;

    Frame() : targets(stage.targets()) {
        PlanOptions options;
        options.accumulation = Accumulation::Rgba32f;
        plan = must(tyndall::plan(lights, eye(stage), options));
        must(gpu().frozen.upload(data, plan));
    }

    Result<void> record() {
        Result<void> recorded;
        run([&](VkCommandBuffer commands) -> Result<void> {
            recorded = gpu().frozen.record(commands, data, plan, textures, targets);
            return {};
        });
        return recorded;
    }
};

void expectError(const Result<void>& result, ErrorCode code, std::string_view says) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, code);
    EXPECT_NE(result.error().message.find(says), std::string::npos) << result.error().message;
}

using RecordArguments = GpuTest;

TEST_F(RecordArguments, TheFrameThatTheOthersSpoilIsGood) {
    Frame frame;
    const auto recorded = frame.record();
    ASSERT_TRUE(recorded) << recorded.error().message;
}

TEST_F(RecordArguments, PlanThatWasNotUploaded) {
    Frame frame;
    frame.data = FrameData();
    expectError(frame.record(), ErrorCode::InvalidArgument, "upload()");
}

TEST_F(RecordArguments, AnotherPlanWasUploaded) {
    Frame frame;
    frame.plan.vertices.push_back({});
    expectError(frame.record(), ErrorCode::InvalidArgument, "upload()");
}

TEST_F(RecordArguments, GroupThatDoesNotExist) {
    Frame frame;
    run([&](VkCommandBuffer commands) -> Result<void> {
        expectError(gpu().frozen.recordComposite(commands, frame.data, frame.plan, 1, frame.targets),
                    ErrorCode::InvalidArgument, "group 1");
        expectError(gpu().frozen.recordAccumulation(commands, frame.data, frame.plan, 7, frame.textures, frame.targets),
                    ErrorCode::InvalidArgument, "group 7");
        return {};
    });
}

TEST_F(RecordArguments, TooFewTextures) {
    Frame frame;
    frame.textures.clear();
    expectError(frame.record(), ErrorCode::InvalidArgument, "textures");
}

TEST_F(RecordArguments, LightOfAGroupThatIsNotDrawn) {
    Frame frame;
    frame.plan.lights[0].drawn = false;
    expectError(frame.record(), ErrorCode::InvalidArgument, "light 0");
}

TEST_F(RecordArguments, GroupThatNamesALightBeyondThePlan) {
    Frame frame;
    frame.plan.parts[0].light = 5;
    expectError(frame.record(), ErrorCode::InvalidArgument, "light 5");
}

TEST_F(RecordArguments, GroupWithPartsBeyondThePlan) {
    Frame frame;
    frame.plan.groups[0].parts = 7;
    expectError(frame.record(), ErrorCode::InvalidArgument, "parts");
}

TEST_F(RecordArguments, ConstantsBeyondThePlan) {
    Frame frame;
    frame.plan.parts[0].constants = 7;
    expectError(frame.record(), ErrorCode::InvalidArgument, "constants");
}

TEST_F(RecordArguments, IndicesBeyondThePlan) {
    Frame frame;
    frame.plan.parts[0].indexCount += 3;
    expectError(frame.record(), ErrorCode::InvalidArgument, "indices");
    frame.plan.indices[0] = static_cast<std::uint32_t>(frame.plan.vertices.size());
    expectError(gpu().frozen.upload(frame.data, frame.plan), ErrorCode::InvalidArgument, "beyond its vertices");
}

TEST_F(RecordArguments, TargetsWithoutPixelsOrImages) {
    Frame frame;
    frame.targets.extent.height = 0;
    expectError(frame.record(), ErrorCode::InvalidArgument, "48x0");
    frame.targets = frame.stage.targets();
    frame.targets.accumulationView = VK_NULL_HANDLE;
    expectError(frame.record(), ErrorCode::InvalidArgument, "accumulation");
    frame.targets = frame.stage.targets();
    frame.targets.colour = VK_NULL_HANDLE;
    expectError(frame.record(), ErrorCode::InvalidArgument, "colour view");
    frame.targets = frame.stage.targets();
    frame.targets.depth = VK_NULL_HANDLE;
    frame.targets.blur = true;
    expectError(frame.record(), ErrorCode::InvalidArgument, "blur");
}

TEST_F(RecordArguments, FormatThatCannotBeBlended) {
    Frame frame;
    frame.targets.colourFormat = VK_FORMAT_R8G8B8A8_UINT;
    expectError(frame.record(), ErrorCode::UnsupportedDevice, "VkFormat 41");
    frame.targets = frame.stage.targets();
    frame.targets.depthFormat = VK_FORMAT_R8G8B8A8_UNORM;
    expectError(frame.record(), ErrorCode::UnsupportedDevice, "VkFormat 37");
}

TEST_F(RecordArguments, ShadowMapsOfImpossibleLightsOrMeshes) {
    Frame frame;
    const VkImageView map = frame.stage.depth.view();
    const auto attempt = [&](const Light& light, const Occluder& occluder, VkImageView view, std::uint32_t size) {
        Result<void> recorded;
        run([&](VkCommandBuffer commands) -> Result<void> {
            recorded = gpu().frozen.recordShadowMap(commands, frame.data, light, std::span(&occluder, 1), view,
                                                    VK_FORMAT_D32_SFLOAT, size);
            return {};
        });
        return recorded;
    };
    expectError(attempt(lamp(), {}, VK_NULL_HANDLE, 8), ErrorCode::InvalidArgument, "has no view");
    expectError(attempt(lamp(), {}, map, 0), ErrorCode::InvalidArgument, "0 texels");
    for (const double angle : {0.0, -1.0, 3.15, std::numeric_limits<double>::quiet_NaN()}) {
        Light light = lamp();
        light.fov.y = angle;
        expectError(attempt(light, {}, map, 8), ErrorCode::InvalidArgument, "field of view");
    }
    Light light = lamp();
    light.nearPlane = light.farPlane;
    expectError(attempt(light, {}, map, 8), ErrorCode::InvalidArgument, "near < far");
    Occluder occluder;
    occluder.indexCount = 3;
    expectError(attempt(lamp(), occluder, map, 8), ErrorCode::InvalidArgument, "no vertex or index buffer");
    const auto buffer = must(
        headless::Buffer::create(gpu().device, 64, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT,
                                 headless::MemoryKind::Host));
    occluder.vertices = occluder.indices = buffer.handle();
    occluder.vertexStride = 10;
    expectError(attempt(lamp(), occluder, map, 8), ErrorCode::InvalidArgument, "10 bytes apart");
}

TEST(RecordDevice, NullHandles) {
    const auto renderer = Renderer::create({});
    ASSERT_FALSE(renderer);
    EXPECT_EQ(renderer.error().code, ErrorCode::InvalidArgument);
}

TEST(RecordDevice, WithoutPushDescriptors) {
    headless::DeviceOptions options;
    options.pushDescriptors = false;
    const auto device = headless::Device::create(options);
    ASSERT_TRUE(device) << device.error().message;
    const auto renderer = Renderer::create({device->physicalDevice(), device->device(), VK_NULL_HANDLE});
    ASSERT_FALSE(renderer);
    EXPECT_EQ(renderer.error().code, ErrorCode::UnsupportedDevice);
    EXPECT_NE(renderer.error().message.find("VK_KHR_push_descriptor"), std::string::npos) << renderer.error().message;
}

TEST_F(RecordArguments, FrameDataOfAnotherDevice) {
    const auto other = must(headless::Device::create({}));
    auto renderer = must(Renderer::create({other.physicalDevice(), other.device(), VK_NULL_HANDLE}));
    Frame frame;
    expectError(renderer.upload(frame.data, frame.plan), ErrorCode::InvalidArgument, "another device");
}

}  // namespace
}  // namespace tyndall::test

// The headless kit itself: images return what was uploaded, memory is freed, and validation reports errors, including
// synchronization. Without those reports all other tests would miss them.
#include <gtest/gtest.h>
#include <headless/buffer.h>
#include <headless/commands.h>
#include <headless/device.h>
#include <headless/image.h>
#include <headless/statistics.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace headless {
namespace {

Result<Device> lavapipe(bool skipInvalidCalls = false) {
    DeviceOptions options;
    options.validation = true;
    options.preferSoftware = true;
    options.skipInvalidCalls = skipInvalidCalls;
    return Device::create(options);
}

bool anyHas(const std::vector<std::string>& messages, std::string_view part) {
    return std::any_of(messages.begin(), messages.end(),
                       [&](const std::string& message) { return message.find(part) != std::string::npos; });
}

/// Sets an environment variable during its lifetime.
class ScopedVariable {
public:
    ScopedVariable(const char* name, const char* value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before, had_ = true;
        setenv(name, value, 1);
    }
    ScopedVariable(const ScopedVariable&) = delete;
    ScopedVariable& operator=(const ScopedVariable&) = delete;
    ~ScopedVariable() { had_ ? setenv(name_, before_.c_str(), 1) : unsetenv(name_); }

private:
    const char* name_;
    std::string before_;
    bool had_ = false;
};

TEST(Headless, RunsOnLavapipe) {
    const auto device = lavapipe();
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_TRUE(device->isLlvmpipe()) << device->name();
    EXPECT_TRUE(device->messages().empty());
}

struct FormatCase {
    const char* name;
    VkFormat format;
    std::uint32_t bytes;
};

class HeadlessReadback : public testing::TestWithParam<FormatCase> {};

TEST_P(HeadlessReadback, GivesTheTexelsThatWereUploaded) {
    const auto device = lavapipe();
    ASSERT_TRUE(device) << device.error().message;
    // Odd sides reveal row padding.
    const ImageInfo info{{13, 7},
                         GetParam().format,
                         VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                         "round trip"};
    const auto image = Image::create(*device, info);
    ASSERT_TRUE(image) << image.error().message;
    ASSERT_EQ(texelBytes(GetParam().format), GetParam().bytes);
    std::vector<std::byte> texels(13u * 7u * GetParam().bytes);
    // Bytes below 0x3e: finite in every float format, and depth within [0, 1].
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::byte>(i * 7 % 0x3e);
    const auto uploaded = upload(*device, *image, texels);
    ASSERT_TRUE(uploaded) << uploaded.error().message;
    const auto back = readback(*device, *image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(*back, texels);
    for (const std::string& message : device->messages()) ADD_FAILURE() << message;
}

INSTANTIATE_TEST_SUITE_P(, HeadlessReadback,
                         testing::Values(FormatCase{"r8", VK_FORMAT_R8_UNORM, 1},
                                         FormatCase{"rgba8", VK_FORMAT_R8G8B8A8_UNORM, 4},
                                         FormatCase{"srgba8", VK_FORMAT_R8G8B8A8_SRGB, 4},
                                         FormatCase{"rgba16f", VK_FORMAT_R16G16B16A16_SFLOAT, 8},
                                         FormatCase{"rgba32f", VK_FORMAT_R32G32B32A32_SFLOAT, 16},
                                         FormatCase{"d16", VK_FORMAT_D16_UNORM, 2},
                                         FormatCase{"d32", VK_FORMAT_D32_SFLOAT, 4}),
                         [](const auto& row) { return row.param.name; });

TEST(Headless, GivesMemoryBack) {
    const auto device = lavapipe();
    ASSERT_TRUE(device) << device.error().message;
    {
        auto buffer = Buffer::create(*device, 1000, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, MemoryKind::Device, "a");
        ASSERT_TRUE(buffer) << buffer.error().message;
        EXPECT_TRUE(buffer->mapped().empty());
        const auto held = device->memoryAllocated();
        EXPECT_GE(held, 1000u);
        Buffer moved = std::move(*buffer);
        EXPECT_EQ(buffer->handle(), VK_NULL_HANDLE);
        EXPECT_EQ(device->memoryAllocated(), held);
        const auto image = Image::create(*device, {{32, 32}, VK_FORMAT_R8G8B8A8_UNORM, VK_IMAGE_USAGE_SAMPLED_BIT});
        ASSERT_TRUE(image) << image.error().message;
        EXPECT_GE(device->memoryAllocated(), held + 32 * 32 * 4);
    }
    EXPECT_EQ(device->memoryAllocated(), 0u);
    EXPECT_GE(device->peakMemoryAllocated(), 1000u + 32 * 32 * 4);
}

TEST(Headless, ObjectsMayOutliveTheirDevice) {
    Buffer buffer;
    {
        const auto device = lavapipe();
        ASSERT_TRUE(device) << device.error().message;
        auto made = Buffer::create(*device, 16, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, MemoryKind::Host);
        ASSERT_TRUE(made) << made.error().message;
        buffer = std::move(*made);
    }
    buffer.mapped()[0] = std::byte{1};
}

TEST(Headless, CollectsAValidationMessage) {
    const auto device = lavapipe(true);
    ASSERT_TRUE(device) << device.error().message;
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;  // and no size
    VkBuffer buffer = VK_NULL_HANDLE;
    vkCreateBuffer(device->device(), &info, nullptr, &buffer);
    EXPECT_TRUE(anyHas(device->messages(), "VUID-VkBufferCreateInfo-size-00912"));
}

TEST(Headless, CollectsASynchronizationHazardWithTheObjectsNames) {
    auto device = lavapipe(true);
    ASSERT_TRUE(device) << device.error().message;
    constexpr VkBufferUsageFlags usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    const auto from = Buffer::create(*device, 64, usage, MemoryKind::Host, "hazard source");
    const auto to = Buffer::create(*device, 64, usage, MemoryKind::Host, "hazard target");
    const auto done = submitAndWait(*device, [&](VkCommandBuffer commands) {
        const VkBufferCopy copy{0, 0, 64};
        vkCmdCopyBuffer(commands, from->handle(), to->handle(), 1, &copy);
        vkCmdCopyBuffer(commands, from->handle(), to->handle(), 1, &copy);
    });
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_TRUE(anyHas(device->messages(), "SYNC-HAZARD-WRITE-AFTER-WRITE"));
    EXPECT_TRUE(anyHas(device->messages(), "hazard target"));
    device->clearMessages();
    EXPECT_TRUE(device->messages().empty());
}

TEST(Headless, FullBarrierOrdersCopies) {
    const auto device = lavapipe();
    ASSERT_TRUE(device) << device.error().message;
    constexpr VkBufferUsageFlags usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    const auto from = Buffer::create(*device, 64, usage, MemoryKind::Host);
    const auto to = Buffer::create(*device, 64, usage, MemoryKind::Host);
    const auto done = submitAndWait(*device, [&](VkCommandBuffer commands) {
        const VkBufferCopy copy{0, 0, 64};
        vkCmdCopyBuffer(commands, from->handle(), to->handle(), 1, &copy);
        fullBarrier(commands);
        vkCmdCopyBuffer(commands, from->handle(), to->handle(), 1, &copy);
    });
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_GT(*done, 0.0);
    EXPECT_TRUE(device->messages().empty());
}

TEST(Headless, TellsWhatIsLeftOverWhenTheDeviceGoes) {
    std::vector<std::string> messages;
    {
        DeviceOptions options;
        options.validation = true;
        options.onMessage = [&](const std::string& message) { messages.push_back(message); };
        const auto device = Device::create(options);
        ASSERT_TRUE(device) << device.error().message;
        VkFenceCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
        VkFence fence = VK_NULL_HANDLE;
        ASSERT_EQ(vkCreateFence(device->device(), &info, nullptr, &fence), VK_SUCCESS);
    }
    EXPECT_TRUE(anyHas(messages, "VkFence"));
}

TEST(Headless, SubmitsNothingWhereRecordingFails) {
    const auto device = lavapipe();
    ASSERT_TRUE(device) << device.error().message;
    const auto done = submitAndWait(*device, [](VkCommandBuffer) -> Result<void> {
        return tl::unexpected(Error{ErrorCode::InvalidArgument, "no", VK_SUCCESS});
    });
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().message, "no");
    EXPECT_TRUE(device->messages().empty());
}

TEST(Headless, CountsNoFragmentsWhereNothingIsDrawn) {
    const auto device = lavapipe();
    ASSERT_TRUE(device) << device.error().message;
    const auto counter = FragmentCounter::create(*device);
    ASSERT_TRUE(counter) << counter.error().message;
    const auto done = submitAndWait(*device, [&](VkCommandBuffer commands) {
        counter->begin(commands);
        counter->end(commands);
    });
    ASSERT_TRUE(done) << done.error().message;
    const auto count = counter->invocations();
    ASSERT_TRUE(count) << count.error().message;
    EXPECT_EQ(*count, 0u);
    EXPECT_TRUE(device->messages().empty());
}

TEST(HeadlessErrors, NoDriver) {
    const ScopedVariable files("VK_DRIVER_FILES", "/nonexistent.json");
    const ScopedVariable icds("VK_ICD_FILENAMES", "/nonexistent.json");
    const auto device = Device::create();
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().code, ErrorCode::UnsupportedDevice);
    EXPECT_NE(device.error().message.find("install"), std::string::npos) << device.error().message;
}

TEST(HeadlessErrors, NoValidationLayer) {
    const ScopedVariable layers("VK_LAYER_PATH", "/nonexistent");
    const auto device = lavapipe();
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().code, ErrorCode::UnsupportedDevice);
    EXPECT_NE(device.error().message.find("VK_LAYER_KHRONOS_validation"), std::string::npos);
}

TEST(HeadlessErrors, NoDeviceOfThatName) {
    DeviceOptions options;
    options.deviceName = "abacus";
    const auto device = Device::create(options);
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().code, ErrorCode::UnsupportedDevice);
    EXPECT_NE(device.error().message.find("'abacus'"), std::string::npos) << device.error().message;
    EXPECT_NE(device.error().message.find("llvmpipe"), std::string::npos) << device.error().message;
}

TEST(HeadlessErrors, ImagesOfImpossibleSizeOrFormat) {
    const auto device = lavapipe();
    ASSERT_TRUE(device) << device.error().message;
    for (const VkExtent2D extent : {VkExtent2D{0, 8}, VkExtent2D{8, 0}, VkExtent2D{100000, 8}, VkExtent2D{8, 100000}}) {
        const auto image = Image::create(*device, {extent, VK_FORMAT_R8G8B8A8_UNORM, VK_IMAGE_USAGE_SAMPLED_BIT});
        ASSERT_FALSE(image);
        EXPECT_EQ(image.error().code, ErrorCode::InvalidArgument);
        EXPECT_NE(image.error().message.find(std::to_string(extent.width) + "x"), std::string::npos);
    }
    const auto depth = Image::create(*device, {{8, 8}, VK_FORMAT_D32_SFLOAT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT});
    ASSERT_FALSE(depth);
    EXPECT_EQ(depth.error().code, ErrorCode::UnsupportedDevice);
    EXPECT_EQ(device->memoryAllocated(), 0u);
    EXPECT_TRUE(device->messages().empty());
}

TEST(HeadlessErrors, UploadsOfTheWrongSize) {
    const auto device = lavapipe();
    ASSERT_TRUE(device) << device.error().message;
    const auto image = Image::create(
        *device, {{4, 4}, VK_FORMAT_R8G8B8A8_UNORM, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    ASSERT_TRUE(image) << image.error().message;
    const auto uploaded = upload(*device, *image, std::vector<std::byte>(63));
    ASSERT_FALSE(uploaded);
    EXPECT_EQ(uploaded.error().message, "the image takes 64 bytes, 63 were given");
    EXPECT_FALSE(Buffer::create(*device, 0, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, MemoryKind::Host));
}

}  // namespace
}  // namespace headless

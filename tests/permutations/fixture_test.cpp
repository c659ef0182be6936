// The fixture itself must detect mistakes.
#include <headless/buffer.h>
#include <headless/commands.h>

#include "draw.h"

namespace tyndall::test {
namespace {

std::vector<std::string> messagesAfter(const std::function<void(VkCommandBuffer, const headless::Buffer&)>& mistake) {
    headless::DeviceOptions options;
    options.validation = true;
    options.preferSoftware = true;
    options.skipInvalidCalls = true;
    const headless::Device device = must(headless::Device::create(options));
    const headless::Buffer buffer = must(headless::Buffer::create(
        device, 64, VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT, headless::MemoryKind::Device));
    EXPECT_TRUE(device.messages().empty());
    (void)headless::submitAndWait(device, [&](VkCommandBuffer commands) { mistake(commands, buffer); });
    return device.messages();
}

bool mentions(const std::vector<std::string>& messages, std::string_view text) {
    for (const std::string& message : messages)
        if (message.find(text) != std::string::npos) return true;
    return false;
}

TEST(Fixture, ValidationIsHeard) {
    const auto messages = messagesAfter([](VkCommandBuffer commands, const headless::Buffer& buffer) {
        vkCmdFillBuffer(commands, buffer.handle(), 0, 1000, 0);  // past its end
    });
    EXPECT_TRUE(mentions(messages, "VUID-vkCmdFillBuffer-size"));
}

TEST(Fixture, SynchronizationValidationIsHeard) {
    const auto messages = messagesAfter([](VkCommandBuffer commands, const headless::Buffer& buffer) {
        vkCmdFillBuffer(commands, buffer.handle(), 0, 64, 0);
        vkCmdFillBuffer(commands, buffer.handle(), 0, 64, 1);  // no barrier between two writes
    });
    EXPECT_TRUE(mentions(messages, "SYNC-HAZARD-WRITE-AFTER-WRITE"));
}

TEST(Fixture, NotFiniteIsFound) {
    Picture picture{2, 1, {{0, 0, 0, 0}, {0, 0, 0, 0}}};
    const std::vector<Allowed> anything(2, Allowed{Interval{-1, 1}, {-1, 1}, {-1, 1}, {-1, 1}});
    EXPECT_EQ(whyOutside(picture, 1.0, anything), "");
    picture.pixels[1][2] = NAN;
    EXPECT_NE(whyNotFinite(picture), "");
    EXPECT_NE(whyOutside(picture, 1.0, anything), "");
    picture.pixels[1][2] = INFINITY;
    EXPECT_NE(whyNotFinite(picture), "");
}

TEST(Fixture, OneValueOutsideIsFound) {
    Picture picture{2, 1, {{0, 0, 0, 0}, {0, 0, 0, 0}}};
    const std::vector<Allowed> narrow(2, Allowed{});
    EXPECT_EQ(whyOutside(picture, 1.0, narrow), "");
    picture.pixels[0][3] = 1e-7f;
    EXPECT_NE(whyOutside(picture, 1.0, narrow), "");
}

}  // namespace
}  // namespace tyndall::test

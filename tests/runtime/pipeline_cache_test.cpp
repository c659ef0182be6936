// Sealed pipeline caches: for any change of the bytes, opening returns either the original data or an error.
#include <gtest/gtest.h>
#include <tyndall/pipeline_cache.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <random>
#include <string>

namespace tyndall {
namespace {

VkPhysicalDeviceProperties aDevice() {
    VkPhysicalDeviceProperties properties{};
    properties.vendorID = 0x10005;
    properties.deviceID = 0x0a0b0c0d;
    properties.driverVersion = 0x01020304;
    std::strcpy(properties.deviceName, "Test Device");
    for (std::size_t i = 0; i < VK_UUID_SIZE; ++i)
        properties.pipelineCacheUUID[i] = static_cast<std::uint8_t>(0xf0 + i);
    return properties;
}

std::vector<std::byte> bytesOf(std::initializer_list<std::uint32_t> words) {
    std::vector<std::byte> bytes;
    for (const std::uint32_t word : words)
        for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::byte>(word >> (8 * i)));
    return bytes;
}

/// A driver's data: Vulkan's header and `more` bytes.
std::vector<std::byte> dataOf(const VkPhysicalDeviceProperties& device, std::size_t more, std::uint32_t headerSize = 32,
                              std::uint32_t version = 1) {
    std::vector<std::byte> data = bytesOf({headerSize, version, device.vendorID, device.deviceID});
    for (const std::uint8_t byte : device.pipelineCacheUUID) data.push_back(static_cast<std::byte>(byte));
    std::mt19937 random(static_cast<std::uint32_t>(more));
    for (std::size_t i = 0; i < more; ++i) data.push_back(static_cast<std::byte>(random()));
    return data;
}

void expectRefused(std::span<const std::byte> sealed, const VkPhysicalDeviceProperties& device,
                   const std::string& says = {}) {
    const auto opened = openPipelineCache(sealed, device);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::InvalidArgument);
    EXPECT_NE(opened.error().message.find(says), std::string::npos) << opened.error().message;
}

TEST(PipelineCache, WhatWasSealedComesBack) {
    for (const std::size_t more : {0, 1, 15, 240, 241, 100000}) {
        const std::vector<std::byte> data = dataOf(aDevice(), more);
        const std::vector<std::byte> sealed = sealPipelineCache(data, aDevice());
        EXPECT_EQ(sealed.size(), pipelineCacheSeal + data.size());
        EXPECT_TRUE(isSealedPipelineCache(sealed));
        const auto opened = openPipelineCache(sealed, aDevice());
        ASSERT_TRUE(opened) << opened.error().message;
        EXPECT_TRUE(std::ranges::equal(*opened, data));
        EXPECT_EQ((opened->data() - sealed.data()) % 16, 0);
    }
}

TEST(PipelineCache, FieldsHaveTheirLowestByteFirst) {
    const std::vector<std::byte> sealed = sealPipelineCache(dataOf(aDevice(), 0x101 - 32), aDevice());
    const std::vector<std::byte> expected = bytesOf({1, sizeof(void*), 0x10005, 0x0a0b0c0d, 0x01020304, 0, 0x101, 0,
                                                     0xf3f2f1f0, 0xf7f6f5f4, 0xfbfaf9f8, 0xfffefdfc, 0, 0});
    EXPECT_TRUE(std::ranges::equal(std::span(sealed).subspan(8, expected.size()), expected));
}

TEST(PipelineCache, AnyByteChangedToAnyOtherIsRefused) {
    std::vector<std::byte> sealed = sealPipelineCache(dataOf(aDevice(), 40), aDevice());
    for (std::byte& byte : sealed) {
        const std::byte good = byte;
        for (int value = 0; value < 256; ++value) {
            byte = static_cast<std::byte>(value);
            ASSERT_EQ(openPipelineCache(sealed, aDevice()).has_value(), byte == good)
                << "byte " << &byte - sealed.data() << " as " << value;
        }
        byte = good;
    }
}

TEST(PipelineCache, EveryOtherLengthIsRefused) {
    std::vector<std::byte> sealed = sealPipelineCache(dataOf(aDevice(), 40), aDevice());
    expectRefused({}, aDevice());
    for (std::size_t length = 1; length < 8; ++length) {
        // Only the name of the format: a truncated cache.
        EXPECT_TRUE(isSealedPipelineCache(std::span(sealed).first(length)));
        expectRefused(std::span(sealed).first(length), aDevice(), "cut short");
    }
    for (std::size_t length = 8; length < sealed.size(); ++length)
        expectRefused(std::span(sealed).first(length), aDevice(), "cut short");
    sealed.push_back(std::byte{0});
    expectRefused(sealed, aDevice(), "followed by 1 bytes");
    sealed.insert(sealed.end(), sealed.begin(), sealed.end());
    expectRefused(sealed, aDevice(), "followed by");
}

TEST(PipelineCache, OtherFilesAreNotOurs) {
    for (const std::string text : {"glTF", "some words that are no cache", "\n"}) {
        const auto bytes = std::as_bytes(std::span(text));
        EXPECT_FALSE(isSealedPipelineCache(bytes));
        expectRefused(bytes, aDevice(), "not a sealed pipeline cache");
    }
    const std::vector<std::byte> raw = dataOf(aDevice(), 100);
    expectRefused(raw, aDevice(), "not a sealed pipeline cache");
}

struct Difference {
    const char* name;
    std::function<void(VkPhysicalDeviceProperties&)> change;
    const char* says;
};

class PipelineCacheOf : public testing::TestWithParam<Difference> {};

TEST_P(PipelineCacheOf, IsRefused) {
    VkPhysicalDeviceProperties other = aDevice();
    GetParam().change(other);
    // Both parts from the other device, then only the seal, then only the data.
    expectRefused(sealPipelineCache(dataOf(other, 40), other), aDevice(), GetParam().says);
    expectRefused(sealPipelineCache(dataOf(aDevice(), 40), other), aDevice(), GetParam().says);
    const auto data = dataOf(other, 40);
    if (data != dataOf(aDevice(), 40))
        expectRefused(sealPipelineCache(data, aDevice()), aDevice(), "data are of another device or driver");
}

INSTANTIATE_TEST_SUITE_P(
    Another, PipelineCacheOf,
    testing::Values(Difference{"Vendor", [](auto& device) { device.vendorID ^= 0x100; }, "another device"},
                    Difference{"Device", [](auto& device) { device.deviceID ^= 0x1000000; }, "another device"},
                    Difference{"Driver", [](auto& device) { device.driverVersion += 1; }, "another version"},
                    Difference{"FirstOfUuid", [](auto& device) { device.pipelineCacheUUID[0] ^= 1; }, "driver"},
                    Difference{"LastOfUuid", [](auto& device) { device.pipelineCacheUUID[15] ^= 1; }, "driver"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(PipelineCache, DataWithoutVulkansOwnHeaderAreRefused) {
    const std::vector<std::byte> data = dataOf(aDevice(), 40);
    for (std::size_t size = 0; size < 32; ++size)
        expectRefused(sealPipelineCache(std::span(data).first(size), aDevice()), aDevice(), "fewer than Vulkan's");
    for (const std::uint32_t headerSize : {0u, 31u, 33u, 0x20000000u})
        expectRefused(sealPipelineCache(dataOf(aDevice(), 40, headerSize), aDevice()), aDevice(), "version one");
    for (const std::uint32_t version : {0u, 2u, 0x01000000u})
        expectRefused(sealPipelineCache(dataOf(aDevice(), 40, 32, version), aDevice()), aDevice(), "version one");
}

TEST(PipelineCache, AnotherVersionOfTheSealIsNamed) {
    std::vector<std::byte> sealed = sealPipelineCache(dataOf(aDevice(), 40), aDevice());
    sealed[8] = std::byte{7};
    expectRefused(sealed, aDevice(), "version 7 of its format, not 1");
}

}  // namespace
}  // namespace tyndall

// Passes that compute, run on lavapipe with validation and held to the same sums on the CPU.
#include <gtest/gtest.h>
#include <headless/buffer.h>
#include <headless/commands.h>
#include <headless/device.h>
#include <headless/image.h>
#include <summing.fx.h>
#include <tyndall/image_format.h>
#include <tyndall/pass_pipelines.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <glm/gtc/packing.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace tyndall::test {
namespace {

constexpr std::uint32_t kWidth = 12, kHeight = 6;  // no multiples of the thread groups
constexpr std::uint32_t kShift = 5;
constexpr glm::vec4 kGain{1.0f, 2.0f, 0.5f, 4.0f};
constexpr std::uint32_t kGroupWidth = 8, kGroupHeight = 4, kGroupThreads = 32;

template <class T>
T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    if constexpr (!std::is_void_v<T>) return std::move(*result);
}

const permgen::Pass& pass(std::string_view technique, std::size_t index = 0) {
    return permgen::find_technique(summing::effect, technique)->passes[index];
}

/// Small whole numbers, so that every sum is exact, in half floats too.
glm::vec4 slideTexel(std::uint32_t x, std::uint32_t y) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(x + y), 1.0f};
}

struct Weight {
    float colour[3];
    float gain;
};
Weight weight(std::uint32_t x) {
    return {{static_cast<float>(x + 1), 2.0f, 3.0f}, static_cast<float>(x)};
}

/// What cs_sum() computes for a thread.
glm::vec4 expected(std::uint32_t x, std::uint32_t y, bool weighted) {
    const auto shared = [&](std::uint32_t index) {
        const std::uint32_t column = x / kGroupWidth * kGroupWidth + index % kGroupWidth;
        const std::uint32_t row = y / kGroupHeight * kGroupHeight + index / kGroupWidth;
        return slideTexel(std::min(column, kWidth - 1), std::min(row, kHeight - 1)) * kGain;
    };
    const std::uint32_t index = y % kGroupHeight * kGroupWidth + x % kGroupWidth;
    glm::vec4 sum = shared(index) + shared((index + kShift) % kGroupThreads);
    if (!weighted) return sum;
    const Weight w = weight(x);
    return {sum.x * w.colour[0], sum.y * w.colour[1], sum.z * w.colour[2], sum.w + w.gain};
}

void expectError(const auto& result, ErrorCode code, std::string_view says) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, code);
    EXPECT_NE(result.error().message.find(says), std::string::npos) << result.error().message;
}

class ComputeTest : public testing::TestWithParam<Shaders> {
protected:
    ComputeTest() : pipelines(must(PassPipelines::create(context(), summing::effect))) {
        std::vector<glm::vec4> texels;
        for (std::uint32_t y = 0; y < kHeight; ++y)
            for (std::uint32_t x = 0; x < kWidth; ++x) texels.push_back(slideTexel(x, y));
        must(headless::upload(device, slide, std::as_bytes(std::span(texels))));
        // The block as permgen lays it out.
        const auto put = [&](std::string_view name, const auto& value) {
            std::memcpy(globals.mapped().data() + permgen::find_member(summing::effect, name)->offset, &value,
                        sizeof value);
        };
        put("gGain", kGain);
        put("nSize", std::array{kWidth, kHeight});
        put("nShift", kShift);
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const Weight w = weight(x);
            std::memcpy(weights.mapped().data() + x * sizeof w, &w, sizeof w);
        }
        for (const headless::Buffer* buffer : {&sums, &counts})
            std::fill(buffer->mapped().begin(), buffer->mapped().end(), std::byte{0});
    }
    void TearDown() override {
        for (const std::string& message : device.messages()) ADD_FAILURE() << "validation: " << message;
    }

    DeviceContext context() const {
        DeviceContext result{device.physicalDevice(), device.device()};
        result.shaders = GetParam();
        return result;
    }
    static headless::Device lavapipe() {
        headless::DeviceOptions options;
        options.validation = true;
        options.preferSoftware = true;
        return must(headless::Device::create(options));
    }
    headless::Image image(VkFormat format, VkImageUsageFlags usage) const {
        usage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
        return must(headless::Image::create(device, {{kWidth, kHeight}, format, usage, "computed"}));
    }
    headless::Image storageImage(std::string_view resource) const {
        return image(vulkanFormat(permgen::find_resource(summing::effect, resource)->format),
                     VK_IMAGE_USAGE_STORAGE_BIT);
    }
    headless::Buffer buffer(VkDeviceSize size, VkBufferUsageFlags usage) const {
        return must(headless::Buffer::create(device, size, usage, headless::MemoryKind::Host));
    }

    /// The named resources; those that `unused` names are left out.
    Result<std::uint32_t> push(VkCommandBuffer commands, const PassPipeline& pipeline,
                               const std::vector<std::string_view>& unused = {}) {
        const auto left_out = [&](std::string_view name) {
            return std::find(unused.begin(), unused.end(), name) != unused.end();
        };
        std::vector<NamedBuffer> buffers{{"Globals", {globals.handle(), 0, globals.size()}},
                                         {"Weights", {weights.handle(), 0, weights.size()}},
                                         {"Sums", {sums.handle(), 0, sums.size()}},
                                         {"Counts", {counts.handle(), 0, counts.size()}}};
        std::vector<NamedImage> images{{"Slide", slide.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
                                       {"Picture", picture.view(), VK_IMAGE_LAYOUT_GENERAL},
                                       {"Small", small.view(), VK_IMAGE_LAYOUT_GENERAL}};
        std::erase_if(buffers, [&](const NamedBuffer& named) { return left_out(named.block); });
        std::erase_if(images, [&](const NamedImage& named) { return left_out(named.sampler); });
        return pipelines.push(commands, pipeline, buffers, images);
    }

    void record(const std::function<Result<void>(VkCommandBuffer)>& commands) {
        must(headless::submitAndWait(device, commands));
    }

    /// Runs the passes one after the other over all texels.
    void compute(const std::vector<const permgen::Pass*>& passes, const std::vector<std::string_view>& unused = {}) {
        std::vector<PassPipeline> ready;
        for (const permgen::Pass* one : passes) ready.push_back(must(pipelines.get(*one)));
        record([&](VkCommandBuffer commands) -> Result<void> {
            for (const headless::Image* written : {&picture, &small})
                headless::transition(commands, *written, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
            pipelines.recordNeutralResources(commands);
            for (std::size_t i = 0; i < passes.size(); ++i) {
                vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, ready[i].handle);
                if (auto pushed = push(commands, ready[i], unused); !pushed) return tl::unexpected(pushed.error());
                const auto groups = groupCounts(*passes[i], {kWidth, kHeight, 1});
                vkCmdDispatch(commands, groups[0], groups[1], groups[2]);
                headless::fullBarrier(commands);
            }
            return {};
        });
    }

    template <class Value>
    std::vector<Value> texels(const headless::Image& computed) {
        const std::vector<std::byte> bytes = must(headless::readback(device, computed, VK_IMAGE_LAYOUT_GENERAL));
        std::vector<Value> values(bytes.size() / sizeof(Value));
        std::memcpy(values.data(), bytes.data(), bytes.size());
        return values;
    }
    template <class Value>
    static Value valueAt(const headless::Buffer& buffer, std::size_t index) {
        Value value;
        std::memcpy(&value, buffer.mapped().data() + index * sizeof value, sizeof value);
        return value;
    }

    headless::Device device = lavapipe();
    PassPipelines pipelines;
    headless::Image slide = image(VK_FORMAT_R32G32B32A32_SFLOAT, VK_IMAGE_USAGE_SAMPLED_BIT);
    headless::Image picture = storageImage("Picture");
    headless::Image small = storageImage("Small");
    headless::Buffer globals =
        buffer(permgen::find_resource(summing::effect, "Globals")->size, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    headless::Buffer weights = buffer(kWidth * sizeof(Weight), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    headless::Buffer sums = buffer(kWidth * kHeight * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    headless::Buffer counts = buffer(2 * sizeof(std::uint32_t), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
};

INSTANTIATE_TEST_SUITE_P(Summing, ComputeTest, testing::Values(Shaders::Frozen, Shaders::Specialized),
                         [](const auto& shaders) {
                             return shaders.param == Shaders::Frozen ? "Frozen" : "Specialized";
                         });

static_assert(groupCounts(summing::effect.techniques[0].passes[0], {12, 6, 1}) ==
              std::array<std::uint32_t, 3>{2, 2, 1});
static_assert(groupCounts(summing::effect.techniques[0].passes[0], {16, 4, 1}) ==
              std::array<std::uint32_t, 3>{2, 1, 1});
static_assert(groupCounts(summing::effect.techniques[0].passes[0], {0xffffffffu, 1, 2}) ==
              std::array<std::uint32_t, 3>{0x20000000u, 1, 2});
// C++ lays Weight out as the shader does.
static_assert(permgen::find_resource(summing::effect, "Weights")->size == sizeof(Weight));

TEST_P(ComputeTest, ThePlainPassIsTheSumOnTheCpu) {
    // What the pass does not use gets no buffer and no image.
    compute({&pass("plain")}, {"Weights", "Counts", "Small"});
    const auto drawn = texels<glm::vec4>(picture);
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            EXPECT_EQ(drawn[y * kWidth + x], expected(x, y, false)) << x << ", " << y;
            EXPECT_EQ(valueAt<float>(sums, y * kWidth + x), expected(x, y, false).x) << x << ", " << y;
        }
    EXPECT_EQ(valueAt<std::uint32_t>(counts, 0), 0u);
    EXPECT_EQ(pipelines.count(), 1u);
}

TEST_P(ComputeTest, TheWeightedPassesAreTheSumsOnTheCpu) {
    compute({&pass("weighted", 0), &pass("weighted", 1)});
    const auto drawn = texels<glm::vec4>(picture);
    const auto halves = texels<glm::u16vec4>(small);
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            SCOPED_TRACE(std::to_string(x) + ", " + std::to_string(y));
            const std::size_t i = y * kWidth + x;
            const glm::vec4 sum = expected(x, y, true);
            EXPECT_EQ(drawn[i], 0.5f * sum) << "the second pass reads and writes the image";
            EXPECT_EQ(valueAt<float>(sums, i), sum.x);
            for (int c = 0; c < 4; ++c) EXPECT_EQ(glm::unpackHalf1x16(halves[i][c]), sum[c]);
        }
    EXPECT_EQ(valueAt<std::uint32_t>(counts, 0), kGroupWidth * kHeight);
    EXPECT_EQ(valueAt<std::uint32_t>(counts, 1), (kWidth - kGroupWidth) * kHeight);
}

TEST_P(ComputeTest, APipelineIsMadeOnceForEachPass) {
    const VkPipeline first = must(pipelines.get(pass("plain"))).handle;
    EXPECT_EQ(must(pipelines.get(pass("plain"))).handle, first);
    EXPECT_NE(must(pipelines.get(pass("weighted"))).handle, first);
    EXPECT_EQ(pipelines.count(), 2u);
}

TEST_P(ComputeTest, ReadsSaysWhatIsLive) {
    const PassPipeline plain = must(pipelines.get(pass("plain")));
    EXPECT_TRUE(reads(plain, "Globals") && reads(plain, "Slide") && reads(plain, "Picture") && reads(plain, "Sums"));
    EXPECT_FALSE(reads(plain, "Weights") || reads(plain, "Counts") || reads(plain, "Small"));
    EXPECT_TRUE(reads(must(pipelines.get(pass("weighted"))), "Small"));
}

TEST_P(ComputeTest, SaysWhatIsMissing) {
    expectError(pipelines.get(pass("drawn")), ErrorCode::InvalidArgument,
                "drawn: the pass draws; ask for its pipeline");
    expectError(pipelines.get(pass("plain"), {}, {}), ErrorCode::InvalidArgument,
                "plain: the pass computes; ask for its pipeline without target");
    const permgen::Pass copy = pass("plain");
    expectError(pipelines.get(copy), ErrorCode::InvalidArgument, "none of the effect summing");
    const PassPipeline weighted = must(pipelines.get(pass("weighted")));
    record([&](VkCommandBuffer commands) -> Result<void> {
        expectError(push(commands, weighted, {"Small"}), ErrorCode::InvalidArgument,
                    "the storage image Small has no image");
        expectError(push(commands, weighted, {"Counts"}), ErrorCode::InvalidArgument,
                    "the storage buffer Counts has no buffer");
        expectError(push(commands, weighted, {"Globals"}), ErrorCode::InvalidArgument,
                    "the uniform block Globals has no buffer to read");
        expectError(push(commands, weighted, {"Slide"}), ErrorCode::InvalidArgument,
                    "the sampler Slide has no image to read");
        return {};
    });
}

TEST_P(ComputeTest, AGroupBeyondTheDeviceIsRefused) {
    const VkPhysicalDeviceLimits& limits = device.properties().limits;
    permgen::Module module = *pass("plain").compute.module;
    permgen::Pass changed = pass("plain");
    changed.compute.module = &module;
    const permgen::Technique technique{"changed", {&changed, 1}};
    permgen::Effect effect = summing::effect;
    effect.techniques = {&technique, 1};
    PassPipelines other = must(PassPipelines::create(context(), effect));
    module.group_size = {1, 1, limits.maxComputeWorkGroupSize[2] + 1};
    expectError(other.get(changed), ErrorCode::UnsupportedDevice, "threads along axis 2 at most, and cs_sum wants");
    module.group_size = {limits.maxComputeWorkGroupSize[0], limits.maxComputeWorkGroupInvocations, 1};
    expectError(other.get(changed), ErrorCode::UnsupportedDevice, "; write a smaller [numthreads]");
}

TEST(ImageFormats, AreVulkans) {
    using permgen::ImageFormat;
    EXPECT_EQ(vulkanFormat(ImageFormat::None), VK_FORMAT_UNDEFINED);
    EXPECT_EQ(vulkanFormat(ImageFormat::Rgba32f), VK_FORMAT_R32G32B32A32_SFLOAT);
    EXPECT_EQ(vulkanFormat(ImageFormat::Rgba16f), VK_FORMAT_R16G16B16A16_SFLOAT);
    EXPECT_EQ(vulkanFormat(ImageFormat::Rgba8), VK_FORMAT_R8G8B8A8_UNORM);
    EXPECT_EQ(vulkanFormat(ImageFormat::R11g11b10f), VK_FORMAT_B10G11R11_UFLOAT_PACK32);
    EXPECT_EQ(vulkanFormat(ImageFormat::Rg8snorm), VK_FORMAT_R8G8_SNORM);
    EXPECT_EQ(vulkanFormat(ImageFormat::R32i), VK_FORMAT_R32_SINT);
    EXPECT_EQ(vulkanFormat(ImageFormat::Rgb10a2ui), VK_FORMAT_A2B10G10R10_UINT_PACK32);
    EXPECT_EQ(vulkanFormat(ImageFormat::R8ui), VK_FORMAT_R8_UINT);
}

}  // namespace
}  // namespace tyndall::test

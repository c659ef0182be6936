// The float forms of the raycast shaders, as the device computes them, against long double.
#include <float_forms.fx.h>
#include <gtest/gtest.h>
#include <headless/buffer.h>
#include <headless/commands.h>
#include <tyndall/pass_pipelines.h>
#include <tyndall/rendering.h>

#include <cmath>
#include <cstring>
#include <random>

#include "gpu.h"

namespace tyndall::test {
namespace {

constexpr VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;

class FloatForms : public GpuTest {
protected:
    /// The technique's value for each of the inputs.
    static std::vector<float> evaluate(std::string_view technique, const std::vector<glm::vec4>& inputs) {
        const auto width = static_cast<std::uint32_t>(inputs.size());
        Texture texture{static_cast<int>(width), 1, 4, {}};
        for (const glm::vec4& input : inputs)
            for (int i = 0; i < 4; ++i) texture.texels.push_back(input[i]);
        const headless::Image source = uploadTexture(texture);
        headless::ImageInfo info;
        info.extent = {width, 1};
        info.format = format;
        info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
        info.name = "values";
        const headless::Image target = must(headless::Image::create(gpu().device, info));
        const std::array corners{glm::vec2(-1, -1), glm::vec2(3, -1), glm::vec2(-1, 3)};
        const glm::vec4 constants(static_cast<float>(width), 0.0f, 0.0f, 0.0f);
        const headless::Buffer triangle = must(headless::Buffer::create(gpu().device, std::as_bytes(std::span(corners)),
                                                                        VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "triangle"));
        const headless::Buffer block = must(headless::Buffer::create(
            gpu().device, std::as_bytes(std::span(&constants, 1)), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, "constants"));
        auto pipelines =
            must(PassPipelines::create({gpu().device.physicalDevice(), gpu().device.device()}, float_forms::effect));
        constexpr std::array<VertexElement, 1> elements{{{"POSITION0", 0, VK_FORMAT_R32G32_SFLOAT}}};
        const PassPipeline pipeline = must(pipelines.get(
            permgen::find_technique(float_forms::effect, technique)->passes[0], {.colours = {format}}, elements));
        must(headless::submitAndWait(gpu().device, [&](VkCommandBuffer commands) -> Result<void> {
            headless::transition(commands, target, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
            const VkRenderingAttachmentInfo colour =
                attachment(target.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR);
            beginRendering(commands, {width, 1}, {&colour, 1}, nullptr);
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.handle);
            const VkBuffer vertices = triangle.handle();
            const VkDeviceSize offset = 0, stride = sizeof(glm::vec2);
            vkCmdBindVertexBuffers2(commands, 0, 1, &vertices, &offset, nullptr, &stride);
            const std::array buffers{NamedBuffer{"Globals", {block.handle(), 0, sizeof constants}}};
            const std::array images{
                NamedImage{"InputSampler", source.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}};
            const auto pushed = pipelines.push(commands, pipeline, buffers, images);
            if (pushed) vkCmdDraw(commands, 3, 1, 0, 0);
            vkCmdEndRendering(commands);
            if (!pushed) return tl::unexpected(pushed.error());
            return {};
        }));
        const std::vector<std::byte> bytes =
            must(headless::readback(gpu().device, target, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL));
        std::vector<glm::vec4> texels(inputs.size());
        std::memcpy(texels.data(), bytes.data(), bytes.size());
        std::vector<float> values;
        for (const glm::vec4& texel : texels) values.push_back(texel.x);
        return values;
    }

    /// The largest relative difference to `exact`, and the inputs where it occurs.
    template <class Exact>
    static void expectWithin(std::string_view technique, const std::vector<glm::vec4>& inputs, double bound,
                             const Exact& exact) {
        const std::vector<float> values = evaluate(technique, inputs);
        double worst = 0.0;
        std::size_t at = 0;
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const long double wanted = exact(inputs[i]);
            const double error = static_cast<double>(std::fabs((values[i] - wanted) / wanted));
            if (!(error <= worst)) worst = error, at = i;
        }
        RecordProperty("worst", std::to_string(worst * 1e9) + "e-9");
        EXPECT_LE(worst, bound) << "at " << inputs[at].x << ", " << inputs[at].y << ", " << inputs[at].z << ", "
                                << inputs[at].w << ": " << values[at];
    }
};

// From 1e-12 to 1e12, evenly on a logarithmic scale, of either sign.
float anySize(std::mt19937& random, double least = 1e-12, double most = 1e12) {
    std::uniform_real_distribution<double> exponent(std::log(least), std::log(most));
    return static_cast<float>(std::exp(exponent(random)));
}

TEST_F(FloatForms, ArcOverSideHoldsAtEveryAngle) {
    std::mt19937 random(1);
    std::vector<glm::vec4> inputs;
    for (int i = 0; i < 4000; ++i) {
        const float y = anySize(random), x = anySize(random);
        inputs.push_back({y, i % 2 ? x : -x, 0, 0});
        // Beside the borders of its three parts.
        inputs.push_back({y, y * (1.0f + static_cast<float>(i - 2000) * 1e-7f) * (i % 2 ? 1.0f : -1.0f), 0, 0});
    }
    for (const float x : {1e-6f, 1.0f, 1e6f}) inputs.push_back({0.0f, x, 0, 0});
    expectWithin("arc", inputs, 4e-7, [](const glm::vec4& v) {
        const long double y = v.x, x = v.y;
        return y == 0.0L ? 1.0L / x : std::atan2(y, x) / y;
    });
}

// The error relative to the larger product: 2^-34, a thousandth of a plain difference's 2^-24.
TEST_F(FloatForms, DifferencesOfProductsSurviveCancellation) {
    std::mt19937 random(2);
    std::vector<glm::vec4> inputs;
    for (int i = 0; i < 8000; ++i) {
        const float a = anySize(random, 1e-4, 1e4), b = anySize(random, 1e-4, 1e4), c = anySize(random, 1e-4, 1e4);
        // d such that both products agree in all, some or none of their digits.
        const float apart = 1.0f + (i % 3 == 0 ? 0.0f : anySize(random, 1e-7, 1.0));
        inputs.push_back({a, b, c, a * b / c * apart});
    }
    const std::vector<float> values = evaluate("products", inputs);
    double worst = 0.0, plain = 0.0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const glm::vec4& v = inputs[i];
        const long double product = static_cast<long double>(v.x) * v.y;
        const long double exact = product - static_cast<long double>(v.z) * v.w;
        // Rounding of the result itself is no fault.
        const long double error = std::fabs(values[i] - exact) - 1.2e-7L * std::fabs(exact);
        worst = std::max(worst, static_cast<double>(error / std::fabs(product)));
        const float first = v.x * v.y, second = v.z * v.w;
        plain = std::max(plain, static_cast<double>(std::fabs(first - second - exact) / std::fabs(product)));
    }
    EXPECT_LE(worst, std::exp2(-34.0));
    EXPECT_GT(plain, std::exp2(-25.0)) << "the inputs do not cancel";
}

TEST_F(FloatForms, ThePhaseFunctionHoldsInItsPeak) {
    std::mt19937 random(3);
    std::vector<glm::vec4> inputs;
    for (int i = 0; i < 4000; ++i) {
        const double angle = i % 2 ? anySize(random, 1e-6, 3.0) : 3.14159 - anySize(random, 1e-6, 3.0);
        const double g = (i % 4 < 2 ? 1.0 : -1.0) * (1.0 - anySize(random, 1e-3, 1.0));
        const auto f = static_cast<float>(g);
        inputs.push_back({std::cos(angle), std::sin(angle), f, 1.0 - std::fabs(static_cast<double>(f))});
    }
    // Its inputs are rounded unit vectors: near the peak of the narrowest phase, 1e-3 wide, their angle is off by 1e-4
    // of its width, and the phase by 3e-4... of which the chord form keeps the rounding of 6e-8 / 1e-3.
    expectWithin("phases", inputs, 1e-3, [](const glm::vec4& v) {
        const long double angle = std::atan2(static_cast<long double>(v.y), static_cast<long double>(v.x)), g = v.z;
        const long double base = (1 - std::fabs(g)) * (1 - std::fabs(g)) +
                                 4 * std::fabs(g) * std::pow(g < 0 ? std::cos(angle / 2) : std::sin(angle / 2), 2);
        return (1 - g * g) / (base * std::sqrt(base));
    });
}

}  // namespace
}  // namespace tyndall::test

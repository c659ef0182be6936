#include "gpu.h"

#include <cstring>
#include <memory>
#include <optional>

#include "effects.h"

namespace tyndall::test {
namespace {

std::unique_ptr<Gpu> theGpu;

// Vulkan objects must be destroyed before static destructors unload their libraries.
class GpuEnvironment : public testing::Environment {
public:
    void TearDown() override { theGpu.reset(); }
};
[[maybe_unused]] const testing::Environment* const environment = testing::AddGlobalTestEnvironment(new GpuEnvironment);

DeviceContext contextOf(const headless::Device& device) {
    DeviceContext context{device.physicalDevice(), device.device(), VK_NULL_HANDLE, Shaders::Frozen};
    context.slices = effectUnderTest("slices");
    context.raycast = effectUnderTest("raycast");
    context.composite = effectUnderTest("composite");
    context.shadowMap = effectUnderTest("shadow_map");
    context.shadowHierarchy = effectUnderTest("shadow_hierarchy");
    return context;
}

}  // namespace

Renderer& Gpu::rendererFor(std::string_view technique, Shaders shaders) {
    std::unique_ptr<StandIn>& entry = standIns[{std::string(technique), shaders}];
    if (!entry) {
        DeviceContext context = contextOf(device);
        if (!context.slices) throw std::runtime_error("slices.fx has no technique " + std::string(technique));
        const permgen::Technique* named = permgen::find_technique(*context.slices, technique);
        if (!named) throw std::runtime_error("the effect has no technique " + std::string(technique));
        auto made = std::make_unique<StandIn>();  // the Renderer keeps pointers into it
        made->techniques.assign(context.slices->techniques.begin(), context.slices->techniques.end());
        for (permgen::Technique& each : made->techniques) each.passes = named->passes;
        made->effect = *context.slices;
        made->effect.techniques = made->techniques;
        context.slices = &made->effect;
        context.shaders = shaders;
        made->renderer = must(Renderer::create(context));
        entry = std::move(made);
    }
    return *entry->renderer;
}

Gpu& gpu() {
    if (!theGpu) {
        headless::DeviceOptions options;
        options.validation = true;
        options.preferSoftware = true;
        headless::Device device = must(headless::Device::create(options));
        if (!device.isLlvmpipe())
            throw std::runtime_error("these tests hold pictures against lavapipe, and this device is " +
                                     std::string(device.name()) + "; install Mesa's Vulkan drivers");
        DeviceContext context = contextOf(device);
        Renderer frozen = must(Renderer::create(context));
        context.shaders = Shaders::Specialized;
        Renderer specialized = must(Renderer::create(context));
        theGpu = std::make_unique<Gpu>(Gpu{std::move(device), std::move(frozen), std::move(specialized), {}});
    }
    return *theGpu;
}

void GpuTest::SetUp() {
    gpu().device.clearMessages();
}

void GpuTest::TearDown() {
    for (const std::string& message : gpu().device.messages()) ADD_FAILURE() << "validation: " << message;
}

headless::Image uploadTexture(const Texture& texture, bool depth, VkImageLayout layout) {
    Texture padded = texture;
    if (texture.channels == 3)
        padded = makeTexture(texture.width, texture.height, 4,
                             [&](int x, int y, int c) { return c < 3 ? texture.at(x, y, c) : 1.0; });
    headless::ImageInfo info;
    info.extent = {static_cast<std::uint32_t>(texture.width), static_cast<std::uint32_t>(texture.height)};
    info.format = depth                  ? VK_FORMAT_D32_SFLOAT
                  : padded.channels == 1 ? VK_FORMAT_R32_SFLOAT
                  : padded.channels == 2 ? VK_FORMAT_R32G32_SFLOAT
                                         : VK_FORMAT_R32G32B32A32_SFLOAT;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
                 (depth ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT : 0);
    info.name = "test texture";
    headless::Image image = must(headless::Image::create(gpu().device, info));
    must(headless::upload(gpu().device, image, std::as_bytes(std::span(padded.texels)), layout));
    return image;
}

Texture downloadDepth(const headless::Image& image, VkImageLayout layout) {
    const std::vector<std::byte> bytes = must(headless::readback(gpu().device, image, layout));
    Texture texture{static_cast<int>(image.extent().width), static_cast<int>(image.extent().height), 1, {}};
    texture.texels.resize(bytes.size() / sizeof(float));
    std::memcpy(texture.texels.data(), bytes.data(), bytes.size());
    return texture;
}

}  // namespace tyndall::test

#include "room_on_gpu.h"

#include <headless/commands.h>
#include <headless/statistics.h>

#include <cstring>

namespace tyndall::test {
namespace {

constexpr VkExtent2D extent{Room::width, Room::height};

headless::Image target(std::string_view name) {
    headless::ImageInfo info;
    info.extent = extent;
    info.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    info.name = name;
    return must(headless::Image::create(gpu().device, info));
}

headless::Image shadowMap() {
    headless::ImageInfo info;
    info.extent = {Room::shadowMapSize, Room::shadowMapSize};
    info.format = VK_FORMAT_D32_SFLOAT;
    info.usage =
        VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    info.name = "shadow map";
    return must(headless::Image::create(gpu().device, info));
}

}  // namespace

RoomOnGpu::RoomOnGpu(const Room& room)
    : maps_(room.lights.size()), views_(room.lights.size()), sum_(target("sum")), colour_(target("picture")) {
    for (std::size_t i = 0; i < room.lights.size(); ++i) {
        const auto add = [&](const Texture& texture, VkImageView& view, VkExtent2D& size) {
            const headless::Image& image = images_.emplace_back(uploadTexture(texture));
            view = image.view();
            size = image.extent();
        };
        if (room.lights[i].cookie) add(room.slides[i], views_[i].cookie, views_[i].cookieSize);
        if (room.lights[i].noise) add(room.dust[i], views_[i].noise, views_[i].noiseSize);
    }
    depth_ = uploadTexture(room.depth, true, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
    drawShadowMaps(room);
}

void RoomOnGpu::drawShadowMaps(const Room& room) {
    std::vector<float> positions;
    std::vector<std::uint32_t> order;
    for (const Triangle& triangle : room.triangles)
        for (const glm::dvec3& corner : triangle) {
            order.push_back(static_cast<std::uint32_t>(order.size()));
            for (int i = 0; i < 3; ++i) positions.push_back(static_cast<float>(corner[i]));
        }
    headless::Buffer vertices, indices;
    std::vector<Occluder> occluders;
    if (!order.empty()) {
        vertices = must(headless::Buffer::create(gpu().device, std::as_bytes(std::span(positions)),
                                                 VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "surfaces"));
        indices = must(headless::Buffer::create(gpu().device, std::as_bytes(std::span(order)),
                                                VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "surfaces"));
        Occluder& occluder = occluders.emplace_back();
        occluder.vertices = vertices.handle();
        occluder.indices = indices.handle();
        occluder.indexCount = static_cast<std::uint32_t>(order.size());
    }
    FrameData frame;
    must(headless::submitAndWait(gpu().device, [&](VkCommandBuffer commands) -> Result<void> {
        for (std::size_t i = 0; i < room.lights.size(); ++i) {
            if (!room.lights[i].shadow) continue;
            maps_[i] = images_.size();
            const headless::Image& map = images_.emplace_back(tyndall::test::shadowMap());
            views_[i].shadowMap = map.view();
            headless::transition(commands, map, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
            if (auto recorded = gpu().frozen.recordShadowMap(commands, frame, room.lights[i], occluders, map.view(),
                                                             map.format(), Room::shadowMapSize);
                !recorded)
                return recorded;
            headless::transition(commands, map, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        }
        return {};
    }));
    must(headless::submitAndWait(gpu().device, [&](VkCommandBuffer commands) -> Result<void> {
        for (std::size_t i = 0; i < room.lights.size(); ++i) {
            if (!room.lights[i].shadow) continue;
            const headless::Image& hierarchy = images_.emplace_back(shadowHierarchyImage(Room::shadowMapSize));
            views_[i].shadowHierarchy = hierarchy.view();
            if (auto recorded =
                    gpu().frozen.recordShadowHierarchy(commands, frame, views_[i].shadowMap, Room::shadowMapSize,
                                                       levelsOf(hierarchy, views_[i].shadowHierarchy));
                !recorded)
                return recorded;
        }
        return {};
    }));
}

Texture RoomOnGpu::shadowMap(std::size_t light) const {
    return downloadDepth(images_[maps_[light]], VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

RoomOnGpu::Shown RoomOnGpu::draw(const Plan& plan, std::span<const LightTextures> textures, Renderer& renderer) const {
    ShaftTargets targets;
    targets.extent = extent;
    targets.accumulation = sum_.handle();
    targets.accumulationView = sum_.view();
    targets.depth = depth_.view();
    targets.depthFormat = depth_.format();
    targets.colour = colour_.view();
    targets.colourFormat = colour_.format();

    const RendererCounters before = renderer.counters();
    const headless::FragmentCounter counter = must(headless::FragmentCounter::create(gpu().device));
    FrameData frame;
    must(renderer.upload(frame, plan));
    must(headless::submitAndWait(gpu().device, [&](VkCommandBuffer commands) -> Result<void> {
        counter.begin(commands);
        Result<void> done;
        for (std::size_t group = 0; group < plan.groups.size() && done; ++group)
            done = renderer.recordAccumulation(commands, frame, plan, group, textures.empty() ? views_ : textures,
                                               targets);
        counter.end(commands);
        return done;
    }));
    Shown shown;
    shown.counters = difference(renderer.counters(), before);
    shown.fragments = must(counter.invocations());
    shown.picture = {Room::width, Room::height, {}};
    shown.picture.pixels.resize(static_cast<std::size_t>(Room::width) * Room::height);
    if (plan.groups.empty()) return shown;  // nothing was drawn to read back
    const std::vector<std::byte> bytes =
        must(headless::readback(gpu().device, sum_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL));
    std::memcpy(shown.picture.pixels.data(), bytes.data(), bytes.size());
    return shown;
}

Renderer freshRenderer() {
    return must(
        Renderer::create({gpu().device.physicalDevice(), gpu().device.device(), VK_NULL_HANDLE, Shaders::Frozen}));
}

}  // namespace tyndall::test

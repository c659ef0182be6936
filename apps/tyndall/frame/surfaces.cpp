#include "surfaces.h"

#include <scene.fx.h>
#include <tyndall/rendering.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>

namespace tyndall::app {
namespace {

/// Ambient light as a share of the lights' illuminance at the far side of the scene. It stands for indirect light,
/// which is not computed.
constexpr double ambientShare = 0.02;
/// Ambient light from below, as a share of that from above.
constexpr float groundShare = 0.4f;

constexpr std::array<VertexElement, 3> elements{{{"POSITION0", offsetof(Vertex, position), VK_FORMAT_R32G32B32_SFLOAT},
                                                 {"NORMAL0", offsetof(Vertex, normal), VK_FORMAT_R32G32B32_SFLOAT},
                                                 {"TEXCOORD0", offsetof(Vertex, uv), VK_FORMAT_R32G32_SFLOAT}}};

/// permgen's name for the block of scene.fx's global variables.
constexpr std::string_view globals = "Globals";

/// Writes members of the effect's uniform block by name, at their offsets.
class Uniforms {
public:
    explicit Uniforms(std::span<std::byte> bytes) : bytes_(bytes) {}
    void set(std::string_view name, const float* values, std::size_t count) {
        const permgen::Member* member = permgen::find_member(scene_effect::effect, name);
        if (member != nullptr && member->offset + 4 * count <= bytes_.size())
            std::memcpy(bytes_.data() + member->offset, values, 4 * count);
    }
    void set(std::string_view name, const glm::dmat4& matrix) {
        const glm::mat4 narrow(matrix);
        set(name, glm::value_ptr(narrow), 16);
    }
    void set(std::string_view name, const glm::dvec4& vector) {
        const glm::vec4 narrow(vector);
        set(name, glm::value_ptr(narrow), 4);
    }

private:
    std::span<std::byte> bytes_;
};

constexpr std::uint32_t blockBytes = permgen::find_resource(scene_effect::effect, globals)->size;

NamedImage named(std::string_view sampler, VkImageView view) {
    return {sampler, view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

/// Radiance that a white surface reflects under ambient light.
glm::dvec3 ambientRadiance(const Scene& scene, std::span<const Light> lights) {
    if (scene.bounds.empty()) return glm::dvec3(0.0);
    const double radius = 0.5 * glm::length(scene.bounds.maximum - scene.bounds.minimum);
    glm::dvec3 intensity(0.0);
    for (const Light& light : lights) intensity += light.intensity * light.colour;
    return radius > 0.0 ? ambientShare / 3.14159265358979 * intensity / (radius * radius) : glm::dvec3(0.0);
}

void setLight(Uniforms& uniforms, const Light& light, std::span<const glm::dvec4> walls, const View& view,
              std::uint32_t shadowSize) {
    std::array<glm::vec4, 4> planes;
    planes.fill(glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    for (std::size_t i = 0; i < std::min(walls.size(), planes.size()); ++i) planes[i] = glm::vec4(walls[i]);
    uniforms.set("gWalls", glm::value_ptr(planes[0]), 4 * planes.size());
    uniforms.set("gLightFromView", glm::inverse(light.worldFromLight) * view.worldFromView);
    uniforms.set("gIntensity", glm::dvec4(light.colour * light.intensity,
                                          light.intensity > 0.0 ? light.ambient / light.intensity : 0.0));
    uniforms.set("gRange", glm::dvec4(light.nearPlane, light.farPlane, 0.0, 0.0));
    const glm::dvec2 slope = tanHalfFov(light);
    uniforms.set("gCookieScale", glm::dvec4(0.5 / slope, 0.0, 0.0));
    const ShadowDepth depth = shadowDepth(light);
    uniforms.set("gShadow", glm::dvec4(depth.constant, depth.overAxis, shadowSize, 0.0));
    uniforms.set("gTexel", glm::dvec4(2.0 * slope / static_cast<double>(shadowSize), 0.0, 0.0));
}

/// The matrix for normals, up to length and sign, scaled to near unit length. For invertible matrices it is a multiple
/// of the inverse transpose.
glm::dmat3 cofactors(const glm::dmat3& m) {
    const glm::dmat3 c(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double longest = std::max({glm::length(c[0]), glm::length(c[1]), glm::length(c[2])});
    return longest > 0.0 ? c / longest : c;
}

void setSurface(Uniforms& uniforms, const MeshInstance& instance, const Material& material, const View& view, bool lit,
                const glm::dvec3& ambient) {
    // Doubles up to here: the result is relative to the eye, and small enough for floats.
    const glm::dmat4 viewFromMesh = glm::inverse(view.worldFromView) * instance.worldFromMesh;
    uniforms.set("gClipFromMesh", view.clipFromView * viewFromMesh);
    uniforms.set("gViewFromMesh", viewFromMesh);
    uniforms.set("gViewFromNormal", glm::dmat4(cofactors(glm::dmat3(viewFromMesh))));
    uniforms.set("gEye", view.orthographic ? glm::dvec4(0.0, 0.0, 1.0, 0.0) : glm::dvec4(0.0, 0.0, 0.0, 1.0));
    uniforms.set("gUp",
                 glm::dvec4(glm::inverse(glm::dmat3(view.worldFromView)) * glm::dvec3(0.0, 1.0, 0.0), groundShare));
    if (!lit) return;
    uniforms.set("gAlbedo", glm::dvec4(glm::dvec3(material.baseColour), 1.0));
    uniforms.set("gEmission", glm::dvec4(glm::dvec3(material.emissive), 0.0));
    uniforms.set("gAmbient", glm::dvec4(ambient, 0.0));
}

/// A key of scene.fx always has a technique.
template <class Key>
const permgen::Pass& passOf(const Key& key) {
    return scene_effect::technique(*scene_effect::find_technique(key)).passes[0];
}

/// One instance, in the base pass or lit by one light.
struct Lit {
    std::size_t instance = 0;
    std::optional<std::size_t> light;
};

/// Base passes come first, because they write depth.
void listDraws(const SurfaceInputs& inputs, std::vector<Lit>& draws) {
    for (std::size_t i = 0; i < inputs.viewed.scene.instances.size(); ++i) draws.push_back({i, std::nullopt});
    for (std::size_t light = 0; light < inputs.lights.size() && inputs.lit; ++light) {
        if (!inputs.lights[light].lit) continue;
        for (const std::size_t instance : inputs.viewed.instancesInLight[light]) draws.push_back({instance, light});
    }
}

}  // namespace

Result<PassPipelines> surfacePipelines(const headless::Device& device, VkPipelineCache cache) {
    auto pipelines = PassPipelines::create({device.physicalDevice(), device.device(), cache}, scene_effect::effect);
    if (!pipelines) return passOn(pipelines.error(), "the surfaces");
    return std::move(*pipelines);
}

Result<void> prepareSurfaces(const headless::Device& device, PassPipelines& pipelines, VkFormat colour, VkFormat depth,
                             const SurfaceInputs& inputs, const GpuScene& gpu, SurfacePass& pass) {
    pass.draws.clear();
    const auto& [viewed, lights, maps, shadowSize, lit] = inputs;
    const Scene& scene = viewed.scene;
    if (scene.instances.empty()) return {};
    std::vector<Lit> draws;
    listDraws(inputs, draws);
    const VkDeviceSize alignment =
        std::max<VkDeviceSize>(device.properties().limits.minUniformBufferOffsetAlignment, 16);
    const VkDeviceSize block = (blockBytes + alignment - 1) / alignment * alignment;
    if (pass.uniforms.size() < block * draws.size()) {
        auto buffer = headless::Buffer::create(device, block * draws.size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                                               headless::MemoryKind::Host, "surface uniforms");
        if (!buffer) return passOn(buffer.error(), "the surfaces' constants");
        pass.uniforms = std::move(*buffer);
    }
    const std::span<std::byte> mapped = pass.uniforms.mapped();
    std::ranges::fill(mapped, std::byte{0});

    const glm::dvec3 ambient = ambientRadiance(scene, viewed.lights);
    VkDeviceSize offset = 0;
    for (const Lit& one : draws) {
        const MeshInstance& instance = scene.instances[one.instance];
        const Material& material = scene.meshes[instance.mesh].material;
        const bool textured = material.baseTexture.has_value() && lit;
        Uniforms uniforms(mapped.subspan(offset, blockBytes));
        setSurface(uniforms, instance, material, viewed.view, lit, ambient);
        SurfaceDraw draw;
        draw.instance = one.instance;
        draw.uniforms = {pass.uniforms.handle(), offset, blockBytes};
        offset += block;
        if (textured) draw.images.push_back(named("BaseColourSampler", gpu.images[*material.baseTexture].view()));
        const permgen::Pass* pixels = &passOf(scene_effect::ps_base_key{.bTexture = textured});
        if (one.light) {
            const std::size_t l = *one.light;
            setLight(uniforms, viewed.lights[l], lights[l].walls, viewed.view, shadowSize);
            const VkImageView map = maps.view(l);
            const bool shadow = map != VK_NULL_HANDLE;
            const std::optional<std::size_t> cookie = scene.lights[l].cookie;
            if (shadow) draw.images.push_back(named("ShadowMapSampler", map));
            if (cookie) draw.images.push_back(named("CookieSampler", gpu.images[*cookie].view()));
            pixels = &passOf(scene_effect::ps_light_key{
                .bShadowMapping = shadow, .bCookie = cookie.has_value(), .bTexture = textured});
        }
        // Culling depends on the mesh; depth is reversed.
        const PassTarget target{.colours = {colour}, .depth = depth, .dynamicCulling = true};
        const auto pipeline = pipelines.get(*pixels, target, elements);
        if (!pipeline) return passOn(pipeline.error(), "the surfaces");
        draw.pipeline = *pipeline;
        pass.draws.push_back(std::move(draw));
    }
    return {};
}

Result<void> recordSurfaces(VkCommandBuffer commands, const PassPipelines& pipelines, const SurfacePass& pass,
                            const Scene& scene, const GpuScene& gpu, const SurfaceTargets& targets) {
    const VkRenderingAttachmentInfo colour =
        attachment(targets.colour, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR);
    const VkRenderingAttachmentInfo depth =
        attachment(targets.depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR);
    beginRendering(commands, targets.extent, {&colour, 1}, &depth);
    for (const SurfaceDraw& draw : pass.draws) {
        const MeshInstance& instance = scene.instances[draw.instance];
        const Mesh& mesh = scene.meshes[instance.mesh];
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, draw.pipeline.handle);
        vkCmdSetCullMode(commands, mesh.material.doubleSided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
        // glTF's front faces are counter-clockwise, mirrored instances' clockwise. Vulkan determines winding with
        // y pointing down, and the projection turns y over to match, so the picture's own winding counts.
        const bool mirrored = glm::determinant(glm::dmat3(instance.worldFromMesh)) < 0.0;
        vkCmdSetFrontFace(commands, mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
        const NamedBuffer block{globals, draw.uniforms};
        if (auto pushed = pipelines.push(commands, draw.pipeline, std::span(&block, 1), draw.images); !pushed)
            return tl::unexpected(pushed.error());
        const VkBuffer vertices = gpu.vertices.handle();
        constexpr VkDeviceSize stride = sizeof(Vertex);
        vkCmdBindVertexBuffers2(commands, 0, 1, &vertices, &gpu.vertexOffset[instance.mesh], nullptr, &stride);
        vkCmdBindIndexBuffer(commands, gpu.indices.handle(), gpu.indexOffset[instance.mesh], VK_INDEX_TYPE_UINT32);
        vkCmdDrawIndexed(commands, static_cast<std::uint32_t>(mesh.indices.size()), 1, 0, 0, 0);
    }
    vkCmdEndRendering(commands);
    return {};
}

}  // namespace tyndall::app

#include "gpu_scene.h"

#include <glm/gtc/packing.hpp>

namespace tyndall::app {
namespace {

/// Half floats: every device filters them linearly (Vulkan 1.3, table 65), but not full floats. 8 bits would show
/// bands in dark linear values.
constexpr VkFormat imageFormat = VK_FORMAT_R16G16B16A16_SFLOAT;

Result<headless::Image> uploadImage(const headless::Device& device, const Image& source) {
    auto image = headless::Image::create(
        device, {.extent = {static_cast<std::uint32_t>(source.width), static_cast<std::uint32_t>(source.height)},
                 .format = imageFormat,
                 .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                 .name = "scene texture"});
    if (!image) return passOn(image.error(), fmt::format("a texture of {}x{}", source.width, source.height));
    std::vector<glm::uint64> texels(pixelCount(source));
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = glm::packHalf4x16(rgbaOf(source, i));
    if (auto done = headless::upload(device, *image, std::as_bytes(std::span(texels))); !done)
        return passOn(done.error(), "a texture could not be uploaded");
    return std::move(*image);
}

template <class T>
Result<headless::Buffer> hostBuffer(const headless::Device& device, const std::vector<T>& values,
                                    VkBufferUsageFlags usage, std::string_view name) {
    auto buffer = headless::Buffer::create(device, std::as_bytes(std::span(values)), usage, name);
    if (!buffer) return passOn(buffer.error(), "the scene's meshes could not be uploaded");
    return std::move(*buffer);
}

}  // namespace

Result<GpuScene> uploadMeshes(const headless::Device& device, const Scene& scene) {
    GpuScene gpu;
    gpu.images.resize(scene.images.size());
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const Mesh& mesh : scene.meshes) {
        gpu.vertexOffset.push_back(vertices.size() * sizeof(Vertex));
        gpu.indexOffset.push_back(indices.size() * sizeof(std::uint32_t));
        vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    }
    if (indices.empty()) return gpu;
    auto vertexBuffer = hostBuffer(device, vertices, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "scene vertices");
    if (!vertexBuffer) return tl::unexpected(vertexBuffer.error());
    auto indexBuffer = hostBuffer(device, indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "scene indices");
    if (!indexBuffer) return tl::unexpected(indexBuffer.error());
    gpu.vertices = std::move(*vertexBuffer);
    gpu.indices = std::move(*indexBuffer);
    return gpu;
}

Result<void> uploadImages(const headless::Device& device, const Scene& scene, const std::vector<bool>& wanted,
                          GpuScene& gpu) {
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        if (!wanted[i] || gpu.images[i].handle()) continue;
        auto image = uploadImage(device, scene.images[i]);
        if (!image) return tl::unexpected(image.error());
        gpu.images[i] = std::move(*image);
        ++gpu.imagesUploaded;
        gpu.imageBytes += pixelCount(scene.images[i]) * headless::texelBytes(imageFormat);
    }
    return {};
}

Occluder occluderOf(const GpuScene& gpu, const Scene& scene, std::size_t instance) {
    const auto& [mesh, worldFromMesh] = scene.instances[instance];
    return {.vertices = gpu.vertices.handle(),
            .vertexOffset = gpu.vertexOffset[mesh],
            .vertexStride = sizeof(Vertex),
            .indices = gpu.indices.handle(),
            .indexOffset = gpu.indexOffset[mesh],
            .indexCount = static_cast<std::uint32_t>(scene.meshes[mesh].indices.size()),
            .worldFromMesh = worldFromMesh};
}

}  // namespace tyndall::app

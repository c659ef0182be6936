// A scene's meshes and pictures on the device.
#pragma once

#include <headless/buffer.h>
#include <headless/image.h>
#include <kit/fail.h>
#include <tyndall/renderer.h>

#include <cstdint>
#include <vector>

#include "../scene/scene.h"

namespace tyndall::app {

struct GpuScene {
    headless::Buffer vertices, indices;      ///< of all meshes, one after the other
    std::vector<VkDeviceSize> vertexOffset;  ///< bytes, by mesh
    std::vector<VkDeviceSize> indexOffset;   ///< bytes, by mesh
    std::vector<headless::Image> images;     ///< by Scene::images; empty if not uploaded yet
    std::uint64_t imagesUploaded = 0, imageBytes = 0;
};

Result<GpuScene> uploadMeshes(const headless::Device& device, const Scene& scene);

/// Uploads the images that are `wanted`, by Scene::images, and not uploaded yet.
Result<void> uploadImages(const headless::Device& device, const Scene& scene, const std::vector<bool>& wanted,
                          GpuScene& gpu);

/// An instance with its current transform.
Occluder occluderOf(const GpuScene& gpu, const Scene& scene, std::size_t instance);

}  // namespace tyndall::app

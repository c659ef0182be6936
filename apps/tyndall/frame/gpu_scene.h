// A scene's meshes and pictures on the device.
#pragma once

#include <headless/buffer.h>
#include <headless/image.h>
#include <tyndall/renderer.h>

#include <cstdint>
#include <vector>

#include <kit/fail.h>
#include "../scene/scene.h"

namespace tyndall::app {

struct GpuScene {
    headless::Buffer vertices, indices;      ///< of all meshes, one after the other
    std::vector<VkDeviceSize> vertexOffset;  ///< bytes, by mesh
    std::vector<VkDeviceSize> indexOffset;   ///< bytes, by mesh
    std::vector<headless::Image> images;     ///< by Scene::images; empty where uploadImages() was not asked for it
    std::uint64_t imagesUploaded = 0, imageBytes = 0;
};

Result<GpuScene> uploadMeshes(const headless::Device& device, const Scene& scene);

/// The images that are `wanted`, by Scene::images, and not there yet.
Result<void> uploadImages(const headless::Device& device, const Scene& scene, const std::vector<bool>& wanted,
                           GpuScene& gpu);

/// An instance where it stands now.
Occluder occluderOf(const GpuScene& gpu, const Scene& scene, std::size_t instance);

}  // namespace tyndall::app

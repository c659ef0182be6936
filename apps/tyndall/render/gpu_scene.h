// A scene's meshes and pictures on the device.
#pragma once

#include <headless/buffer.h>
#include <headless/image.h>
#include <tyndall/renderer.h>

#include <vector>

#include "../outcome.h"
#include "../scene/scene.h"

namespace tyndall::app {

struct GpuScene {
    headless::Buffer vertices, indices;      ///< of all meshes, one after the other
    std::vector<VkDeviceSize> vertexOffset;  ///< bytes, by mesh
    std::vector<VkDeviceSize> indexOffset;   ///< bytes, by mesh
    std::vector<headless::Image> images;     ///< by Scene::images
    std::vector<Occluder> occluders;         ///< by Scene::instances
};

Outcome<GpuScene> uploadScene(const headless::Device& device, const Scene& scene);

}  // namespace tyndall::app

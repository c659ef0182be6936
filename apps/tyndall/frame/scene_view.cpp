#include "scene_view.h"

#include <kit/fail.h>
#include <tyndall/shadow_cache.h>

namespace tyndall::app {
namespace {

MeshBounds boundsOf(const Mesh& mesh) {
    Bounds box;
    for (const std::uint32_t index : mesh.indices) {
        box.minimum = glm::min(box.minimum, glm::dvec3(mesh.vertices[index].position));
        box.maximum = glm::max(box.maximum, glm::dvec3(mesh.vertices[index].position));
    }
    return {box.minimum, box.maximum};
}

}  // namespace

Result<const Camera*> chooseCamera(const Scene& scene, const std::optional<std::string>& name) {
    if (!name) return &scene.cameras.front();
    std::string names;
    for (const Camera& camera : scene.cameras) {
        if (camera.name == *name) return &camera;
        names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", camera.name);
    }
    return fail("--camera: the scene has no camera \"{}\"; it has {}", *name, names);
}

View viewFrom(const Camera& camera, Size size) {
    const double aspect = static_cast<double>(size.width) / size.height;
    return camera.orthographic
               ? orthographicView(camera.worldFromCamera, camera.halfHeight * aspect, camera.halfHeight,
                                  camera.nearPlane, camera.farPlane)
               : perspectiveView(camera.worldFromCamera, camera.verticalFov, aspect, camera.nearPlane, camera.farPlane);
}

std::vector<std::vector<std::size_t>> instancesByLight(const Scene& scene, std::span<const Light> lights) {
    std::vector<MeshBounds> boxes;
    for (const Mesh& mesh : scene.meshes) boxes.push_back(boundsOf(mesh));
    std::vector<std::vector<std::size_t>> found(lights.size());
    for (std::size_t light = 0; light < lights.size(); ++light)
        for (std::size_t i = 0; i < scene.instances.size(); ++i) {
            const MeshInstance& instance = scene.instances[i];
            if (scene.meshes[instance.mesh].indices.empty()) continue;
            if (mayShade(lights[light], instance.worldFromMesh, boxes[instance.mesh])) found[light].push_back(i);
        }
    return found;
}

}  // namespace tyndall::app

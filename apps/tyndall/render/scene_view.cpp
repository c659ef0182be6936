#include "scene_view.h"

#include <array>

namespace tyndall::app {
namespace {

/// Whether the box can be proved to lie outside of the light's volume: all of it beyond one plane.
bool outside(const Bounds& box, const glm::dmat4& worldFromMesh, const Light& light) {
    const glm::dmat4 clipFromMesh = lightClipFromLight(light) * glm::inverse(light.worldFromLight) * worldFromMesh;
    std::array<int, 6> beyond{};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 clip = clipFromMesh * glm::dvec4(corner & 1 ? box.maximum.x : box.minimum.x,
                                                          corner & 2 ? box.maximum.y : box.minimum.y,
                                                          corner & 4 ? box.maximum.z : box.minimum.z, 1.0);
        beyond[0] += clip.x < -clip.w;
        beyond[1] += clip.x > clip.w;
        beyond[2] += clip.y < -clip.w;
        beyond[3] += clip.y > clip.w;
        beyond[4] += clip.z < 0.0;
        beyond[5] += clip.z > clip.w;
    }
    for (const int corners : beyond)
        if (corners == 8) return true;
    return false;
}

Bounds boundsOf(const Mesh& mesh) {
    Bounds box;
    for (const std::uint32_t index : mesh.indices) {
        box.minimum = glm::min(box.minimum, glm::dvec3(mesh.vertices[index].position));
        box.maximum = glm::max(box.maximum, glm::dvec3(mesh.vertices[index].position));
    }
    return box;
}

}  // namespace

Outcome<const Camera*> chooseCamera(const Scene& scene, const std::optional<std::string>& name) {
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

std::vector<Light> callForShadows(const Scene& scene) {
    std::vector<Bounds> boxes;
    for (const Mesh& mesh : scene.meshes) boxes.push_back(boundsOf(mesh));
    std::vector<Light> lights;
    for (const SceneLight& source : scene.lights) {
        Light light = source.light;
        bool occluded = false;
        for (const MeshInstance& instance : scene.instances)
            occluded = occluded || !outside(boxes[instance.mesh], instance.worldFromMesh, light);
        light.shadow = light.shadow && occluded;
        lights.push_back(std::move(light));
    }
    return lights;
}

}  // namespace tyndall::app

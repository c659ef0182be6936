#include "used_images.h"

namespace tyndall::app {
namespace {

void mark(std::vector<bool>& used, const std::optional<std::size_t>& image) {
    if (image) used[*image] = true;
}

}  // namespace

std::vector<bool> surfaceImages(const ViewedScene& viewed, std::span<const SurfaceLight> lights, bool lit) {
    const Scene& scene = viewed.scene;
    std::vector<bool> used(scene.images.size());
    if (!lit) return used;
    for (const MeshInstance& instance : scene.instances) mark(used, scene.meshes[instance.mesh].material.baseTexture);
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].lit && !viewed.instancesInLight[i].empty()) mark(used, scene.lights[i].cookie);
    return used;
}

std::vector<bool> shaftImages(const Scene& scene, const Plan& plan) {
    std::vector<bool> used(scene.images.size());
    for (const PlannedPart& part : plan.parts) {
        const SceneLight& light = scene.lights[plan.lights[part.light].light];
        if (part.terms.contains(Term::Cookie)) mark(used, light.cookie);
        if (part.terms.contains(Term::Noise)) mark(used, light.noise);
    }
    return used;
}

}  // namespace tyndall::app

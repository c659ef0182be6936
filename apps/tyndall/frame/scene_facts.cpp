#include "scene_facts.h"

namespace tyndall::app {
namespace {

std::vector<MeshTriangles> trianglesOf(const Scene& scene) {
    std::vector<MeshTriangles> meshes;
    for (const Mesh& mesh : scene.meshes)
        meshes.push_back({.positions = mesh.vertices.empty() ? nullptr : &mesh.vertices[0].position,
                          .vertices = mesh.vertices.size(),
                          .stride = sizeof(Vertex),
                          .indices = mesh.indices});
    return meshes;
}

/// Rounds to half floats, as the device stores them.
TextureSurvey surveyOf(const Image& image, bool wraps) {
    std::vector<glm::vec4> texels(pixelCount(image));
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = rgbaOf(image, i);
    return surveyHalfFloatTexture(image.width, image.height, texels, wraps);
}

}  // namespace

Result<SceneFacts> surveyScene(const Scene& scene) {
    const std::vector<MeshTriangles> meshes = trianglesOf(scene);
    auto occluders = OccluderSet::fromMeshes(meshes, scene.instances);
    if (!occluders) return tl::unexpected(occluders.error());
    auto blockers = BlockerSet::fromMeshes(meshes, scene.instances);
    if (!blockers) return tl::unexpected(blockers.error());
    SceneFacts facts{std::move(*occluders), std::move(*blockers), {}, {}, {}};
    facts.cookies.resize(scene.images.size());
    facts.noises.resize(scene.images.size());
    for (const SceneLight& light : scene.lights) {
        if (light.cookie && !facts.cookies[*light.cookie])
            facts.cookies[*light.cookie] = surveyOf(scene.images[*light.cookie], false);
        if (light.noise && !facts.noises[*light.noise])
            facts.noises[*light.noise] = surveyOf(scene.images[*light.noise], true);
    }
    for (const SceneLight& light : scene.lights)
        facts.surveys.push_back({light.cookie ? &*facts.cookies[*light.cookie] : nullptr,
                                 light.noise ? &*facts.noises[*light.noise] : nullptr});
    return facts;
}

Result<void> followInstances(SceneFacts& facts, const Scene& scene) {
    bool moved = false;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const auto one = facts.occluders.move(i, scene.instances[i].worldFromMesh);
        if (!one) return tl::unexpected(one.error());
        moved = moved || *one;
    }
    if (!moved) return {};
    if (const auto found = facts.blockers.update(trianglesOf(scene), scene.instances); !found)
        return tl::unexpected(found.error());
    return {};
}

Surroundings surroundingsOf(const SceneFacts& facts) {
    return {.occluders = &facts.occluders, .blockers = &facts.blockers, .depth = {}, .surveys = facts.surveys};
}

}  // namespace tyndall::app

#include "scene_facts.h"

#include <glm/gtc/packing.hpp>

#include "blockers.h"

namespace tyndall::app {
namespace {

/// Of the values that the device gets: half floats.
TextureSurvey surveyOf(const Image& image, bool wraps) {
    std::vector<glm::vec4> texels(image.texels.size());
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = glm::unpackHalf4x16(glm::packHalf4x16(image.texels[i]));
    return surveyTexture(static_cast<int>(image.width), static_cast<int>(image.height), texels, wraps);
}

}  // namespace

SceneFacts surveyScene(const Scene& scene) {
    SceneFacts facts;
    facts.occluders = occluderBoxes(scene);
    facts.blockers = findBlockers(scene);
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

void followInstances(SceneFacts& facts, const Scene& scene) {
    if (moveBoxes(facts.occluders, scene)) facts.blockers = findBlockers(scene);
}

Surroundings surroundingsOf(const SceneFacts& facts) {
    return {.occluders = std::span(facts.occluders.boxes),
            .blockers = facts.blockers,
            .depth = {},
            .surveys = facts.surveys};
}

}  // namespace tyndall::app

#include "shot_reference.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "draw.h"

namespace tyndall::test {
namespace {

// The published constants as lengths of ray in metres: I and ambient for inches, 9 a hundred slices over the
// extent of depth, which all slices together represent.
void giveArticleConstants(Light& light, double depthExtent) {
    light.intensity = 20000.0 * 0.0254 * 0.0254;
    light.ambient = 0.25;
    light.anisotropy = 0.0;
    light.albedo.reset();
    light.density = 4.0 * std::numbers::pi * 900.0 / depthExtent;
    if (light.noise)
        light.noise->gain = 0.05;
    else
        light.density *= 0.015;
}

study::ReferenceScene referenceScene(const Shot& shot, double depthExtent) {
    study::ReferenceScene scene;
    scene.mode = study::Mode::Hardware;
    scene.view = viewOf(shot);
    scene.width = shot.width;
    scene.height = shot.height;
    scene.time = shot.time;
    scene.shadowBias = shot.shadowBias;
    scene.depth = studyTexture(shot.sceneDepth);
    scene.lights.resize(1);
    scene.lights[0].light = shot.light;
    scene.lights[0].cookie = studyTexture(shot.cookieMap);
    scene.lights[0].noise = studyTexture(shot.noiseMap);
    scene.lights[0].shadowMap = studyTexture(shot.shadowMap);
    if (shot.article) giveArticleConstants(scene.lights[0].light, depthExtent);
    return scene;
}

}  // namespace

study::Image studyTexture(const Texture& texture) {
    return {texture.width, texture.height, texture.channels, texture.texels};
}

std::vector<glm::dvec3> truth(const Shot& shot, double depthExtent) {
    auto image = study::reference(referenceScene(shot, depthExtent));
    if (!image) throw std::runtime_error(image.error().message);
    if (shot.article)
        for (int y = 0; y < shot.height; ++y)
            for (int x = 0; x < shot.width; ++x)
                image->radiance[static_cast<std::size_t>(y) * shot.width + x] /=
                    glm::length(pixelRay(shot, x + 0.5, y + 0.5).perMetre);
    return std::move(image->radiance);
}

double relativeL2(const Picture& picture, const std::vector<glm::dvec3>& exact) {
    double error = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double difference = static_cast<double>(picture.pixels[i][c]) - exact[i][c];
            error += difference * difference;
            sum += exact[i][c] * exact[i][c];
        }
    return std::sqrt(error / sum);
}

}  // namespace tyndall::test

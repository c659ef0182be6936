#include "study_scene.h"

#include <cmath>
#include <stdexcept>

#include "scenes.h"

namespace tyndall::test {

using study::Mode, study::ReferenceLight, study::ReferenceScene, study::Triangle;

View eye(glm::dvec3 position, glm::dvec3 direction, double verticalFov, double nearPlane, double farPlane) {
    View view;
    view.worldFromView = lookAlong(position, direction);
    view.nearPlane = nearPlane;
    view.farPlane = farPlane;
    const double t = 1.0 / std::tan(0.5 * verticalFov), n = nearPlane, f = farPlane;
    view.clipFromView = glm::dmat4(0.0);
    view.clipFromView[0][0] = t;
    view.clipFromView[1][1] = -t;
    view.clipFromView[2][2] = n / (f - n);
    view.clipFromView[2][3] = -1.0;
    view.clipFromView[3][2] = n * f / (f - n);
    return view;
}

View parallelEye(glm::dvec3 position, glm::dvec3 direction, double halfHeight, double nearPlane, double farPlane) {
    View view;
    view.worldFromView = lookAlong(position, direction);
    view.nearPlane = nearPlane;
    view.farPlane = farPlane;
    view.orthographic = true;
    view.clipFromView = glm::dmat4(1.0);
    view.clipFromView[0][0] = 1.0 / halfHeight;
    view.clipFromView[1][1] = -1.0 / halfHeight;
    view.clipFromView[2][2] = 1.0 / (farPlane - nearPlane);
    view.clipFromView[3][2] = farPlane / (farPlane - nearPlane);
    return view;
}

Light plainLight() {
    Light light;
    light.name = "plain";
    light.fov = {1.5707963267948966, 1.0471975511965976};
    light.nearPlane = 0.5;
    light.farPlane = 4.0;
    light.intensity = 30.0;
    light.density = 0.05;
    light.cookie = light.shadow = false;
    return light;
}

ReferenceScene oneRay(const Light& light, glm::dvec3 position, glm::dvec3 direction) {
    ReferenceScene scene;
    scene.view = eye(position, direction, 0.8, oneRayNear, 1e4);
    scene.width = scene.height = 1;
    scene.lights.resize(1);
    scene.lights[0].light = light;
    return scene;
}

glm::dvec3 radianceOf(const ReferenceScene& scene, double accuracy) {
    study::ReferenceOptions options;
    options.accuracy = accuracy;
    options.threads = 1;
    const auto image = study::reference(scene, options);
    if (!image) throw std::runtime_error(image.error().message);
    return image->radiance.at(0);
}

std::vector<Triangle> pane(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
    return {{a, b, c, true}, {a, c, d, true}};
}

study::Image speckle(int width, int height, int channels, std::uint64_t seed, double low) {
    Random random(seed);
    study::Image texture{width, height, channels, {}};
    for (int i = 0; i < width * height * channels; ++i)
        texture.values.push_back(static_cast<float>(uniform(random, low, 1.0)));
    return texture;
}

double uniform(Random& random, double low, double high) {
    // 53 bits of the generator: standard distributions differ between libraries.
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

glm::dvec3 direction(Random& random) {
    const double z = uniform(random, -1.0, 1.0), angle = uniform(random, 0.0, 6.283185307179586);
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

ReferenceScene randomScene(std::uint64_t seed, Mode mode) {
    Random random(seed);
    const auto place = [&](double reach) {
        return glm::dvec3(uniform(random, -reach, reach), uniform(random, -reach, reach),
                          uniform(random, -reach, reach));
    };
    ReferenceScene scene;
    scene.mode = mode;
    scene.width = 9;
    scene.height = 7;
    scene.time = uniform(random, 0.0, 1000.0);
    const glm::dvec3 position = place(3.0);
    scene.view = eye(position, place(1.0) - position, uniform(random, 0.4, 2.0));
    const int lights = 1 + static_cast<int>(random() % 3);
    for (int i = 0; i < lights; ++i) {
        ReferenceLight light;
        Light& l = light.light;
        const glm::dvec3 lamp = place(2.0);
        l.worldFromLight = lookAlong(lamp, place(0.5) - lamp, uniform(random, 0.0, 6.0));
        l.fov = {uniform(random, 0.3, 2.2), uniform(random, 0.3, 2.2)};
        l.nearPlane = uniform(random, 0.05, 0.4);
        l.farPlane = uniform(random, 2.0, 6.0);
        l.colour = glm::abs(direction(random));
        l.intensity = uniform(random, 1.0, 50.0);
        l.ambient = i % 2 == 0 ? uniform(random, 0.0, 3.0) : 0.0;
        l.cookie = random() % 2 == 0;
        l.shadow = random() % 4 != 0;
        if (l.cookie) light.cookie = speckle(5, 3, 3, random());
        if (random() % 2 == 0) {
            Noise noise;
            noise.scale = {uniform(random, 0.5, 3.0), uniform(random, -3.0, -0.5)};
            l.noise = noise;
            light.noise = speckle(4, 6, 2, random(), 0.3);
        }
        if (random() % 3 == 0) {
            const double outer = uniform(random, 0.2, 1.0);
            light.cone = study::Cone{random() % 4 == 0 ? outer : uniform(random, 0.0, outer), outer};
        }
        if (random() % 3 == 0) l.clipPlanes = {glm::dvec4(direction(random), uniform(random, 0.0, 1.0))};
        if (mode == Mode::Hardware && l.shadow) {
            light.shadowMap = speckle(16, 16, 1, random());
            for (float& depth : light.shadowMap.values) depth = depth < 0.4f ? 0.0f : 0.2f * depth * depth;
        }
        scene.lights.push_back(light);
    }
    scene.shadowBias = 0.01;
    if (mode == Mode::Ideal)
        for (int i = 0; i < 12; ++i) {
            const glm::dvec3 middle = place(2.0);
            scene.triangles.push_back({middle + place(0.7), middle + place(0.7), middle + place(0.7), i % 2 == 0});
        }
    return scene;
}

ReferenceScene scatteringScene(std::uint64_t seed, Mode mode) {
    ReferenceScene scene = randomScene(seed, mode);
    Random random(seed + 7919);
    if (seed % 3 == 0)
        scene.view = parallelEye(glm::dvec3(scene.view.worldFromView[3]), -glm::dvec3(scene.view.worldFromView[2]),
                                 uniform(random, 0.8, 3.0));
    for (ReferenceLight& light : scene.lights) {
        light.light.density = uniform(random, 0.02, 0.6);
        light.light.anisotropy = uniform(random, -0.95, 0.95);
        if (random() % 3 != 0) light.light.albedo = uniform(random, 0.1, 1.0);
    }
    return scene;
}

}  // namespace tyndall::test

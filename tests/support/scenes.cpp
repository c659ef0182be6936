#include "scenes.h"

#include <cmath>

namespace tyndall::test {
namespace {

// The same on every machine: a multiplicative hash of the texel's position (D. Knuth, TAOCP 3, 6.4).
double speckle(int x, int y, int c) {
    std::uint32_t h = static_cast<std::uint32_t>(x * 73 + y * 9176 + c * 131071 + 1) * 2654435761u;
    h ^= h >> 15;
    h *= 2246822519u;
    h ^= h >> 13;
    return h / 4294967296.0;
}

Light lamp() {
    Light light;
    light.name = "lamp";
    light.worldFromLight = lookAlong({0.4, 2.9, -0.3}, {-0.25, -0.9, 0.2}, 0.4);
    light.fov = {0.8, 0.6};
    light.nearPlane = 0.4;
    light.farPlane = 4.5;
    light.colour = {1.0, 0.75, 0.5};
    light.intensity = 40.0;
    light.density = 0.06;
    light.ambient = 0.7;
    light.anisotropy = 0.6;
    light.albedo = 0.5;
    light.cookie = true;
    light.shadow = true;
    Noise noise;
    noise.scale = {2.5, 1.5};
    noise.scroll1 = {0.02, 0.013};
    noise.scroll2 = {-0.015, 0.024};
    light.noise = noise;
    return light;
}

// A bar, a disc and a single texel at three distances; between them the map is empty.
Texture occluders(const Light& light) {
    return makeTexture(64, 64, 1, [&](int x, int y, int) {
        if (x >= 20 && x < 27) return storedShadowDepth(light, 1.3);
        if (std::hypot(x - 44.0, y - 30.0) < 9.0) return storedShadowDepth(light, 2.2);
        if (x == 40 && y == 52) return storedShadowDepth(light, 0.8);
        return 0.0;
    });
}

Shot from(glm::dvec3 position, glm::dvec3 target, double roll = 0.0) {
    Shot shot = sideView();
    shot.eye.worldFromView = lookAlong(position, target - position, roll);
    return shot;
}

Shot withSurface() {
    Shot shot = sideView();
    shot.sceneDepth = planeDepth(shot, {0.0, 0.6, 0.3}, {-0.5, 0.2, 1.0});
    return shot;
}

Shot withClipPlanes() {
    Shot shot = sideView();
    shot.light.clipPlanes = {{0.0, 1.0, 0.0, -0.4}, {0.6, 0.3, 0.7, 0.1}};
    return shot;
}

Shot orthographic() {
    Shot shot = from({4.0, 2.0, 3.0}, {0.0, 1.2, 0.0});
    shot.eye.orthographic = true;
    shot.eye.halfHeight = 1.9;
    return shot;
}

Shot wide() {
    Shot shot = from({0.6, 1.2, 2.1}, {-0.4, 1.3, 0.1}, 0.3);
    shot.eye.verticalFov = 2.0;
    shot.width = 160;
    shot.height = 90;
    return shot;
}

Shot infiniteFar() {
    Shot shot = from({-1.5, 3.4, 2.8}, {0.0, 1.2, 0.2}, -1.0);
    shot.eye.farPlane = INFINITY;
    shot.sceneDepth = planeDepth(shot, {0.0, 0.3, 0.0}, {0.0, 1.0, 0.1});
    return shot;
}

Shot withSlices(Shot shot, int slices) {
    shot.slices = slices;
    return shot;
}

Shot inArticleLook(Shot shot) {
    shot.article = true;
    return shot;
}

}  // namespace

glm::dmat4 lookAlong(glm::dvec3 position, glm::dvec3 direction, double roll) {
    const glm::dvec3 back = -glm::normalize(direction);
    const glm::dvec3 helper = std::abs(back.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 side = glm::normalize(glm::cross(helper, back));
    const glm::dvec3 over = glm::cross(back, side);
    const glm::dvec3 right = std::cos(roll) * side + std::sin(roll) * over;
    return {glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0), glm::dvec4(back, 0), glm::dvec4(position, 1)};
}

Shot sideView() {
    Shot shot;
    shot.light = lamp();
    shot.eye.worldFromView = lookAlong({0.9, 1.4, 4.6}, {-0.2, 0.0, -1.0});
    shot.eye.verticalFov = 0.8;
    shot.time = 37.25;
    shot.shadowBias = 0.01;
    shot.cookieMap = makeTexture(8, 8, 4, [](int x, int y, int c) { return 0.4 + 0.6 * speckle(x, y, c); });
    shot.noiseMap = makeTexture(8, 8, 2, [](int x, int y, int c) { return 0.4 + 0.6 * speckle(x, y, 7 + c); });
    shot.shadowMap = occluders(shot.light);
    return shot;
}

std::vector<NamedShot> shots() {
    return {
        {"side", sideView()},
        {"side_17_slices", withSlices(sideView(), 17)},
        {"side_1_slice", withSlices(sideView(), 1)},
        {"eye_inside", from({0.2, 1.9, 0.0}, {-1.0, 0.4, 0.9})},
        {"towards_lamp", withSlices(from({-0.45, -0.5, 0.6}, {0.4, 2.9, -0.3}), 23)},
        {"along_the_beam", from({0.6, 3.7, -0.5}, {-0.3, 0.5, 0.2}, 0.2)},
        {"oblique", from({2.9, 4.0, 1.9}, {-0.1, 1.4, 0.1}, 0.7)},
        {"wide_field_of_view", wide()},
        {"surface", withSlices(withSurface(), 15)},
        {"infinite_far_plane", infiniteFar()},
        {"clip_planes", withClipPlanes()},
        {"orthographic", orthographic()},
        {"article_look", inArticleLook(sideView())},
        {"article_look_clip_planes", inArticleLook(withClipPlanes())},
        {"article_look_orthographic", inArticleLook(orthographic())},
    };
}

Shot withTerms(Shot shot, TermSet terms) {
    if (!terms.contains(Term::Noise)) shot.light.noise.reset();
    shot.light.shadow = terms.contains(Term::Shadow);
    shot.light.cookie = terms.contains(Term::Cookie);
    if (!terms.contains(Term::Scattering)) {
        shot.light.anisotropy = 0.0;
        shot.light.albedo.reset();
    }
    return shot;
}

Shot moved(Shot shot, const glm::dmat4& motion) {
    shot.eye.worldFromView = motion * shot.eye.worldFromView;
    shot.light.worldFromLight = motion * shot.light.worldFromLight;
    for (glm::dvec4& plane : shot.light.clipPlanes) plane = glm::transpose(glm::inverse(motion)) * plane;
    return shot;
}

Texture planeDepth(const Shot& shot, glm::dvec3 point, glm::dvec3 normal) {
    return makeTexture(shot.width, shot.height, 1, [&](int x, int y, int) {
        const Ray ray = pixelRay(shot, x + 0.5, y + 0.5);
        const glm::dvec3 origin(shot.eye.worldFromView * glm::dvec4(ray.origin, 1.0));
        const glm::dvec3 direction = glm::dmat3(shot.eye.worldFromView) * ray.perMetre;
        const double depth = glm::dot(normal, point - origin) / glm::dot(normal, direction);
        if (depth < shot.eye.nearPlane || depth > shot.eye.farPlane) return 0.0;
        return storedSceneDepth(shot.eye, depth);
    });
}

}  // namespace tyndall::test

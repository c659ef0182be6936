#include "shape/shadow_projection.h"

#include <tyndall/light.h>

namespace tyndall {

ShadowDepth shadowDepth(const Light& light) {
    // n / (f - n) * (f / w - 1) at w metres along the axis: 1 at n and 0 at f.
    const double n = light.nearPlane;
    const double f = light.farPlane;
    return {-n / (f - n), n * f / (f - n)};
}

glm::dmat4 lightClipFromLight(const Light& light) {
    const glm::dvec2 slope = tanHalfFov(light);
    const ShadowDepth depth = shadowDepth(light);
    glm::dmat4 clip(0.0);
    clip[0][0] = 1.0 / slope.x;
    clip[1][1] = -1.0 / slope.y;  // Vulkan's clip space has y down
    clip[2][2] = -depth.constant;
    clip[2][3] = -1.0;
    clip[3][2] = depth.overAxis;
    return clip;
}

glm::dmat4 lightClipFromWorld(const Light& light) {
    // In double up to here: far from the origin, world coordinates in float would be off by millimetres.
    return lightClipFromLight(light) * glm::inverse(light.worldFromLight);
}

glm::dvec2 texelSlopes(const LightShape& shape, std::uint32_t mapSize, double texels) {
    return 2.0 * texels * shape.tanHalfFov / static_cast<double>(mapSize);
}

double mapErrorShare(const LightShape& shape, const glm::dvec4& plane, std::uint32_t mapSize, double axis) {
    // With p = z (s, -1) for slopes s, a plane n p + d = 0 has z = d / (n.z - n.xy s), so dz / ds = z^2 n.xy / d.
    // Filtering reads the four nearest texels, whose centres lie up to one texel away in both directions.
    return glm::dot(glm::abs(glm::dvec2(plane)), texelSlopes(shape, mapSize, 1.0)) / plane.w * axis;
}

}  // namespace tyndall

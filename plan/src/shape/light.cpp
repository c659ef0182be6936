#include <tyndall/light.h>

namespace tyndall {

glm::dmat4 lightClipFromLight(const Light& light) {
    // Reversed depth of a point at distance w along the axis: n / (f - n) * (f / w - 1), which is 1 at n
    // and 0 at f.
    const double n = light.nearPlane;
    const double f = light.farPlane;
    glm::dmat4 clip(0.0);
    clip[0][0] = 1.0 / glm::tan(0.5 * light.fov.x);
    clip[1][1] = -1.0 / glm::tan(0.5 * light.fov.y);  // Vulkan's clip space has y down
    clip[2][2] = n / (f - n);
    clip[2][3] = -1.0;
    clip[3][2] = n * f / (f - n);
    return clip;
}

glm::dmat4 lightClipFromWorld(const Light& light) {
    // In double all the way: far from the origin, world coordinates in float would be off by millimetres.
    return lightClipFromLight(light) * glm::inverse(light.worldFromLight);
}

}  // namespace tyndall

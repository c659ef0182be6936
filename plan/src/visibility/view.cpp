#include <tyndall/view.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

namespace tyndall {
namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

View viewFrom(const glm::dmat4& worldFromView, double nearPlane, double farPlane, bool orthographic) {
    View view;
    view.worldFromView = worldFromView;
    view.clipFromView = glm::dmat4(0.0);
    view.nearPlane = nearPlane;
    view.farPlane = farPlane;
    view.orthographic = orthographic;
    return view;
}

}  // namespace

View perspectiveView(const glm::dmat4& worldFromView, double verticalFov, double aspect, double nearPlane,
                     double farPlane) {
    View view = viewFrom(worldFromView, nearPlane, farPlane, false);
    glm::dmat4& clip = view.clipFromView;
    if (!(verticalFov > 0.0 && verticalFov < glm::pi<double>() && aspect > 0.0)) {
        clip = glm::dmat4(nowhere);
        return view;
    }
    const double halfFov = 0.5 * verticalFov;
    const double scale = 1.0 / std::tan(halfFov);
    clip[0][0] = scale / aspect;
    clip[1][1] = -scale;  // Vulkan's clip space has y down
    clip[2][3] = -1.0;
    // Reversed depth n / (f - n) * (f / d - 1); its limit for an infinite far plane is n / d.
    const bool infinite = std::isinf(farPlane);
    clip[2][2] = infinite ? 0.0 : nearPlane / (farPlane - nearPlane);
    clip[3][2] = infinite ? nearPlane : nearPlane * farPlane / (farPlane - nearPlane);
    return view;
}

View orthographicView(const glm::dmat4& worldFromView, double halfWidth, double halfHeight, double nearPlane,
                      double farPlane) {
    View view = viewFrom(worldFromView, nearPlane, farPlane, true);
    glm::dmat4& clip = view.clipFromView;
    if (!(halfWidth > 0.0 && halfHeight > 0.0)) {
        clip = glm::dmat4(nowhere);
        return view;
    }
    clip[0][0] = 1.0 / halfWidth;
    clip[1][1] = -1.0 / halfHeight;
    clip[2][2] = 1.0 / (farPlane - nearPlane);
    clip[3][2] = farPlane / (farPlane - nearPlane);
    clip[3][3] = 1.0;
    return view;
}

}  // namespace tyndall

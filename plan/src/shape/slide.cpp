#include "shape/slide.h"

namespace tyndall {

glm::dvec2 cookieScale(const LightShape& shape) {
    return 0.5 / shape.tanHalfFov;
}

glm::dvec2 slideFromSlope(const LightShape& shape, const glm::dvec2& slope) {
    const glm::dvec2 scale = cookieScale(shape);
    return {0.5 + slope.x * scale.x, 0.5 - slope.y * scale.y};  // the slide's top is local +Y
}

glm::dvec2 slopeFromSlide(const LightShape& shape, const glm::dvec2& uv) {
    return glm::dvec2(2.0 * uv.x - 1.0, 1.0 - 2.0 * uv.y) * shape.tanHalfFov;
}

SlideRange slideFromSlopes(const LightShape& shape, const SlopeRange& slopes) {
    return {slideFromSlope(shape, {slopes.min.x, slopes.max.y}), slideFromSlope(shape, {slopes.max.x, slopes.min.y})};
}

glm::dvec4 slidePlane(const LightShape& shape, const glm::dvec2& direction, double bound) {
    // At distance w along the axis u = x scale.x / w + 0.5 and v = 0.5 - y scale.y / w. Times w,
    // dot(direction, uv) - bound is a plane through the lamp.
    const glm::dvec2 scale = cookieScale(shape);
    return {direction.x * scale.x, -direction.y * scale.y, bound - 0.5 * (direction.x + direction.y), 0.0};
}

}  // namespace tyndall

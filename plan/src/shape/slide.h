// Where a light's slide (its cookie, its noise) lies in the air: u to the right, v down, both from 0 to 1 over the
// field of view.
#pragma once

#include <glm/glm.hpp>

#include "shape/light_shape.h"

namespace tyndall {

/// Texture coordinates for each unit of slope.
glm::dvec2 cookieScale(const LightShape& shape);

glm::dvec2 slideFromSlope(const LightShape& shape, const glm::dvec2& slope);
glm::dvec2 slopeFromSlide(const LightShape& shape, const glm::dvec2& uv);

struct SlideRange {
    glm::dvec2 min, max;  ///< u and v
};

SlideRange slideFromSlopes(const LightShape& shape, const SlopeRange& slopes);

/// Light-space half space of the points before the lamp whose slide coordinates have dot(direction, uv) above the
/// bound. The normal has no unit length.
glm::dvec4 slidePlane(const LightShape& shape, const glm::dvec2& direction, double bound);

}  // namespace tyndall

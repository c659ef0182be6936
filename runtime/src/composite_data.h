// The data that composite.fx reads, as bytes.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace tyndall {

/// The uniform block of composite.fx, which explains each value.
struct CompositeConstants {
    glm::vec4 tint;
    glm::vec4 texel;
    glm::vec4 depth;
};

/// One triangle over the whole clip space.
inline constexpr std::array<glm::vec2, 3> screenTriangle{glm::vec2(-1.0f, -1.0f), glm::vec2(3.0f, -1.0f),
                                                         glm::vec2(-1.0f, 3.0f)};

}  // namespace tyndall

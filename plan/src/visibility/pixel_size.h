// The size of a pixel at a distance.
#pragma once

#include <tyndall/view.h>

#include <cstdint>
#include <glm/glm.hpp>

namespace tyndall {

/// Metres that a pixel covers at that view depth, in a picture of `pictureHeight` pixels; 0 for 0 pixels.
inline double pixelSize(const View& view, std::uint32_t pictureHeight, double depth) {
    if (pictureHeight == 0) return 0.0;
    const glm::dmat4 rows = glm::transpose(view.clipFromView);
    const double perHeight = glm::length(glm::dvec3(rows[1])) / (view.orthographic ? rows[3].w : -rows[3].z);
    return 2.0 / (perHeight * pictureHeight) * (view.orthographic ? 1.0 : depth);
}

}  // namespace tyndall

#include "drawn_depth.h"

#include <algorithm>
#include <limits>

namespace tyndall::app {
namespace {

/// Depth comes back in 32 bits; the farthest surface must not lose its last slice to rounding.
constexpr double depthMargin = 1.0 + 1e-5;

/// As fine as pays for a light that fills the picture: a tile costs plan() about a microsecond.
constexpr std::uint32_t mostColumns = 16, mostRows = 9;

double metres(float reversed, const glm::dmat4& viewFromClip, const View& view) {
    if (!(reversed > 0.0f)) return std::numeric_limits<double>::infinity();
    const glm::dvec4 point = viewFromClip * glm::dvec4(0.0, 0.0, reversed, 1.0);
    return std::max(-point.z / point.w * depthMargin, view.nearPlane * depthMargin);
}

}  // namespace

DrawnDepth summarize(std::span<const float> depths, Size size, const View& view) {
    DrawnDepth drawn;
    drawn.columns = std::min(mostColumns, size.width);
    drawn.rows = std::min(mostRows, size.height);
    const glm::dmat4 viewFromClip = glm::inverse(view.clipFromView);
    double farthest = 0.0;
    for (std::uint32_t row = 0; row < drawn.rows; ++row)
        for (std::uint32_t column = 0; column < drawn.columns; ++column) {
            // Every pixel that the tile overlaps: from the one its left edge falls into to the one of its right edge.
            const std::uint32_t left = column * size.width / drawn.columns, top = row * size.height / drawn.rows;
            const std::uint32_t right = ((column + 1) * size.width + drawn.columns - 1) / drawn.columns;
            const std::uint32_t bottom = ((row + 1) * size.height + drawn.rows - 1) / drawn.rows;
            float least = std::numeric_limits<float>::infinity();  // reversed: the farthest
            for (std::uint32_t y = top; y < bottom; ++y)
                for (std::uint32_t x = left; x < right; ++x)
                    least = std::min(least, depths[std::size_t{y} * size.width + x]);
            const double depth = metres(least, viewFromClip, view);
            drawn.tiles.push_back(static_cast<float>(depth));
            farthest = std::max(farthest, depth);
        }
    drawn.farthest = std::min(farthest, View{}.sceneDepth);
    return drawn;
}

}  // namespace tyndall::app

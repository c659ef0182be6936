#include <tyndall/depth_survey.h>

#include <algorithm>
#include <limits>
#include <string>

#include "check/plan_check.h"

namespace tyndall {
namespace {

const std::string depthSurveyPlace = "depth survey";

constexpr std::uint32_t maxColumns = 16, maxRows = 9;

/// The farthest surface must not lose its last slice to rounding.
constexpr double depthMargin = 1.0 + 1e-5;

/// A stored depth farther by what storing and interpolating may have rounded: floats are 2^-24 of their size apart and
/// more, and the same next to 1, where forward depths are crowded.
double farther(float depth, bool reversed) {
    return reversed ? depth * (1.0 - 0x1p-23) : depth + 0x1p-23;
}

/// Whether stored depth falls with distance. It is (a z + b) / (c z + d) for z of view space, which falls with
/// distance: the sign of its derivative by z is that of a d - b c.
bool isReversed(const View& view) {
    const glm::dmat4 rows = glm::transpose(view.clipFromView);
    return rows[2].z * rows[3].w - rows[2].w * rows[3].z > 0.0;
}

/// Metres of a stored depth that is not beyond the far end of the range.
double metres(double depth, const glm::dmat4& viewFromClip) {
    const glm::dvec4 point = viewFromClip * glm::dvec4(0.0, 0.0, depth, 1.0);
    return -point.z / point.w;
}

/// Metres of the farthest surface in a tile whose deepest pixel stores `depth`.
double maxDepthOf(float depth, bool reversed, const glm::dmat4& viewFromClip, const View& view) {
    const double stored = farther(depth, reversed);
    if (reversed ? !(depth > 0.0f) : !(stored < 1.0)) return std::numeric_limits<double>::infinity();
    return std::max(
        {metres(depth, viewFromClip) * depthMargin, metres(stored, viewFromClip), view.nearPlane * depthMargin});
}

/// Every pixel that a tile overlaps: from the one in which its first edge lies to the one of its last edge.
struct Pixels {
    std::uint32_t first, end;
};
Pixels pixelsOf(std::uint32_t tile, std::uint32_t tiles, std::uint32_t side) {
    const std::uint64_t first = std::uint64_t{tile} * side, last = std::uint64_t{tile + 1} * side;
    return {static_cast<std::uint32_t>(first / tiles), static_cast<std::uint32_t>((last + tiles - 1) / tiles)};
}

Result<void> check(std::span<const float> depths, std::uint32_t width, std::uint32_t height, const View& view) {
    if (width == 0 || height == 0 || depths.size() != std::size_t{width} * height)
        return broken(depthSurveyPlace + ": there are " + std::to_string(depths.size()) + " depths for " +
                      std::to_string(width) + " x " + std::to_string(height) +
                      " pixels: there must be width * height of them, one at least; give the whole depth buffer");
    const glm::dvec4 row = glm::transpose(view.clipFromView)[2];
    if (row.x != 0.0 || row.y != 0.0)
        return broken(depthSurveyPlace + ": clipFromView has the third row (" + text(row.x) + ", " + text(row.y) +
                      ", " + text(row.z) + ", " + text(row.w) +
                      "): depth must not depend on x and y; plan without depth tiles where the near plane is oblique");
    return {};
}

}  // namespace

Result<void> surveyDepth(std::span<const float> depths, std::uint32_t width, std::uint32_t height, const View& view,
                         DepthSurvey& survey) {
    if (const Result<void> checked = checkView(view); !checked) return at("view", checked.error());
    if (const Result<void> checked = check(depths, width, height, view); !checked)
        return at(depthSurveyPlace, checked.error());
    survey.columns = std::min(maxColumns, width);
    survey.rows = std::min(maxRows, height);
    survey.tiles.clear();
    survey.farthest = 0.0;
    const bool reversed = isReversed(view);
    const glm::dmat4 viewFromClip = glm::inverse(view.clipFromView);
    const float noSurface = reversed ? 0.0f : 1.0f, nearest = 1.0f - noSurface;
    for (std::uint32_t row = 0; row < survey.rows; ++row)
        for (std::uint32_t column = 0; column < survey.columns; ++column) {
            const Pixels x = pixelsOf(column, survey.columns, width), y = pixelsOf(row, survey.rows, height);
            float deepest = nearest;
            for (std::uint32_t line = y.first; line < y.end; ++line)
                for (const float depth : depths.subspan(std::size_t{line} * width + x.first, x.end - x.first)) {
                    // Not a number fails every comparison, and counts as no surface.
                    const float known = reversed ? (depth > 0.0f ? depth : 0.0f) : (depth < 1.0f ? depth : 1.0f);
                    deepest = reversed ? std::min(deepest, known) : std::max(deepest, known);
                }
            const double depth = maxDepthOf(deepest, reversed, viewFromClip, view);
            survey.tiles.push_back(static_cast<float>(depth));
            survey.farthest = std::max(survey.farthest, depth);
        }
    survey.farthest = std::min(survey.farthest, View{}.sceneDepth);
    return {};
}

}  // namespace tyndall

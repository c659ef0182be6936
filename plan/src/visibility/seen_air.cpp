#include "visibility/seen_air.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tyndall {
namespace {

// Depths were drawn and read back in 32-bit floats.
constexpr double depthMargin = 1.0 + 1e-5;

void widen(SeenAir& air, const ConvexPolyhedron& piece, const LightShape& shape, const View& view,
           const LightPose& pose) {
    // The vertices of a convex solid bound it: in depth, along the axis and in slopes.
    double slant = 1.0;
    for (const glm::dvec3& p : piece.vertices) {
        const glm::dvec3 light(pose.lightFromView * glm::dvec4(p, 1.0));
        const double axis = axisOf(light);
        const glm::dvec2 slope = slopeOf(shape, light);
        if (!air.any) {
            air = {true, -p.z, -p.z, axis, axis, {slope, slope}, 0.0};
        } else {
            air.nearDepth = std::min(air.nearDepth, -p.z);
            air.farDepth = std::max(air.farDepth, -p.z);
            air.axisNear = std::min(air.axisNear, axis);
            air.axisFar = std::max(air.axisFar, axis);
            add(air.slopes, slope);
        }
        if (!view.orthographic) slant = std::max(slant, glm::length(p) / -p.z);
    }
    air.maxLength = std::max(air.maxLength, slant);  // seenAir() multiplies it by the depth
}

// The first and the last tile that a range of clip-space coordinates, -1 to 1, meets.
std::pair<int, int> tilesMet(double min, double max, std::uint32_t count) {
    const auto tile = [&](double x) {
        return static_cast<int>(std::clamp(std::floor(0.5 * (x + 1.0) * count), 0.0, count - 1.0));
    };
    return {tile(min - 1e-9), tile(max + 1e-9)};
}

// The half space of view space on which clip-space coordinate `axis` is at least (sign 1) or at most (-1) `bound`.
glm::dvec4 clipPlane(const glm::dmat4& rows, int axis, double bound, double sign) {
    return unitPlane(sign * (rows[axis] - bound * rows[3]));
}

void addTiles(SeenAir& air, const ConvexPolyhedron& seen, const LightShape& shape, const View& view,
              const LightPose& pose, const DepthTiles& tiles) {
    glm::dvec2 min(std::numeric_limits<double>::infinity()), max(-min);
    double farthest = 0.0;
    for (const glm::dvec3& p : seen.vertices) {
        const glm::dvec4 clip = view.clipFromView * glm::dvec4(p, 1.0);
        min = glm::min(min, glm::dvec2(clip) / clip.w);
        max = glm::max(max, glm::dvec2(clip) / clip.w);
        farthest = std::max(farthest, -p.z);
    }
    const auto [left, right] = tilesMet(min.x, max.x, tiles.columns);
    const auto [top, bottom] = tilesMet(min.y, max.y, tiles.rows);
    const auto depthOf = [&](int column, int row) {
        return depthMargin *
               tiles.farthest[static_cast<std::size_t>(row) * tiles.columns + static_cast<std::size_t>(column)];
    };
    bool open = true;
    for (int row = top; row <= bottom && open; ++row)
        for (int column = left; column <= right && open; ++column) open = depthOf(column, row) >= farthest;
    if (open) return widen(air, seen, shape, view, pose);

    const glm::dmat4 rows = glm::transpose(view.clipFromView);
    const double tolerance = 1e-12 * farthest;
    const auto edge = [](int i, std::uint32_t count) { return 2.0 * i / count - 1.0; };
    for (int row = top; row <= bottom; ++row) {
        ConvexPolyhedron strip = seen;
        if (!cut(strip, clipPlane(rows, 1, edge(row, tiles.rows), 1.0), tolerance) ||
            !cut(strip, clipPlane(rows, 1, edge(row + 1, tiles.rows), -1.0), tolerance))
            continue;
        for (int column = left; column <= right; ++column) {
            ConvexPolyhedron piece = strip;
            if (cut(piece, {0.0, 0.0, 1.0, depthOf(column, row)}, tolerance) &&
                cut(piece, clipPlane(rows, 0, edge(column, tiles.columns), 1.0), tolerance) &&
                cut(piece, clipPlane(rows, 0, edge(column + 1, tiles.columns), -1.0), tolerance))
                widen(air, piece, shape, view, pose);
        }
    }
}

}  // namespace

SeenAir seenAir(const ConvexPolyhedron& seen, const LightShape& shape, const View& view, const LightPose& pose,
                const std::optional<DepthTiles>& tiles) {
    SeenAir air;
    if (tiles)
        addTiles(air, seen, shape, view, pose, *tiles);
    else
        widen(air, seen, shape, view, pose);
    air.maxLength *= air.farDepth - air.nearDepth;
    return air;
}

}  // namespace tyndall

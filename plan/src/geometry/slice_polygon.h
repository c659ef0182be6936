// One slice: the convex polygon in which a plane of constant view depth meets a light's volume.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>

namespace tyndall {

struct SlicePolygon {
    /// A rectangle gains at most one corner from each half plane: 4 + 6 of the light's shape + 6 clip planes + 4 walls
    /// + 8 sides of the cookie + 4 of the guard band + 8 ends and cuts of a partition.
    static constexpr std::size_t capacity = 40;
    std::array<glm::dvec2, capacity> corners;  ///< view-space x and y, counter-clockwise as the eye sees it
    std::size_t count = 0;                     ///< 0, or at least 3
};

/// Cuts the rectangle at view depth `depth` by half spaces of view space that keep dot(n, p) + d >= 0.
/// The result is empty if it has no area. Throws CapacityExceeded, like split().
SlicePolygon slicePolygon(const glm::dvec2& rectangleMin, const glm::dvec2& rectangleMax,
                          std::span<const glm::dvec4> planes, double depth);

/// The parts of a polygon with dot(normal, p) + offset >= 0 and < 0. Both share the corners on the line, bit for bit:
/// drawn side by side they cover every pixel once. A part without area is empty.
void split(const SlicePolygon& whole, const glm::dvec2& normal, double offset, SlicePolygon& inside,
           SlicePolygon& outside);

/// Square metres, positive for a counter-clockwise polygon.
double area(const SlicePolygon& polygon);

}  // namespace tyndall

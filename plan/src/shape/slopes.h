// Where points lie as the lamp sees them: slopes are x / w and y / w of a point in light space, w metres along the
// light's axis.
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace tyndall {

/// Metres along the light's axis.
inline double axisOf(const glm::dvec3& lightPoint) {
    return -lightPoint.z;
}

/// A rectangle of slopes.
struct SlopeRange {
    glm::dvec2 min{0.0}, max{0.0};

    /// Holds no slope; add() makes it a range.
    static SlopeRange none() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return {glm::dvec2(infinity), glm::dvec2(-infinity)};
    }
};

/// Widens the range until it holds the slope.
inline void add(SlopeRange& range, const glm::dvec2& slope) {
    range.min = glm::min(range.min, slope);
    range.max = glm::max(range.max, slope);
}

inline SlopeRange widened(const SlopeRange& range, const glm::dvec2& margin) {
    return {range.min - margin, range.max + margin};
}

inline SlopeRange intersection(const SlopeRange& a, const SlopeRange& b) {
    return {glm::max(a.min, b.min), glm::min(a.max, b.max)};
}

/// 0 for an empty range.
inline double area(const SlopeRange& range) {
    const glm::dvec2 extent = glm::max(range.max - range.min, glm::dvec2(0.0));
    return extent.x * extent.y;
}

}  // namespace tyndall

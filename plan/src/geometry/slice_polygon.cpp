#include "geometry/slice_polygon.h"

#include <source_location>
#include <utility>

#include "geometry/capacity.h"

namespace tyndall {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

void add(SlicePolygon& polygon, const glm::dvec2& corner,
         const std::source_location& where = std::source_location::current()) {
    if (polygon.count >= SlicePolygon::capacity) throwCapacityExceeded(SlicePolygon::capacity, where);
    polygon.corners[polygon.count++] = corner;
}

// Sutherland and Hodgman, "Reentrant polygon clipping", CACM 17 (1), 1974, for one half plane
// dot(normal, p) + offset >= 0. A corner on the line stays and makes no crossing, so no corner is doubled.
// Returns false, and leaves `left` unchanged, if all of `whole` is kept.
bool clip(const SlicePolygon& whole, const glm::dvec2& normal, double offset, SlicePolygon& left) {
    std::array<double, SlicePolygon::capacity> inside;
    bool keptWhole = true;
    for (std::size_t i = 0; i < whole.count; ++i) {
        inside[i] = glm::dot(normal, whole.corners[i]) + offset;
        keptWhole = keptWhole && inside[i] >= 0.0;
    }
    if (keptWhole) return false;
    left.count = 0;
    for (std::size_t i = 0; i < whole.count; ++i) {
        const std::size_t next = i + 1 < whole.count ? i + 1 : 0;
        if (inside[i] >= 0.0) add(left, whole.corners[i]);
        if ((inside[i] > 0.0 && inside[next] < 0.0) || (inside[i] < 0.0 && inside[next] > 0.0))
            add(left, glm::mix(whole.corners[i], whole.corners[next], inside[i] / (inside[i] - inside[next])));
    }
    return true;
}

// Merges corners that rounding split: three planes through one point cut it off twice.
void mergeCorners(SlicePolygon& polygon, double distance) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec2 corner = polygon.corners[i];
        if (kept == 0 || glm::distance(corner, polygon.corners[kept - 1]) > distance) polygon.corners[kept++] = corner;
    }
    while (kept > 1 && glm::distance(polygon.corners[kept - 1], polygon.corners[0]) <= distance) --kept;
    polygon.count = kept;
}

}  // namespace

SlicePolygon slicePolygon(const glm::dvec2& rectangleMin, const glm::dvec2& rectangleMax,
                          std::span<const glm::dvec4> planes, double depth) {
    SlicePolygon buffers[2];
    SlicePolygon* polygon = &buffers[0];
    SlicePolygon* spare = &buffers[1];
    add(*polygon, rectangleMin);
    add(*polygon, {rectangleMax.x, rectangleMin.y});
    add(*polygon, rectangleMax);
    add(*polygon, {rectangleMin.x, rectangleMax.y});
    for (const glm::dvec4& plane : planes)
        if (clip(*polygon, glm::dvec2(plane), plane.w - plane.z * depth, *spare)) std::swap(polygon, spare);

    const double extent = glm::distance(rectangleMin, rectangleMax);
    mergeCorners(*polygon, 1e-12 * extent);
    if (polygon->count < 3 || area(*polygon) <= 1e-16 * extent * extent) polygon->count = 0;
    return *polygon;
}

void split(const SlicePolygon& whole, const glm::dvec2& normal, double offset, SlicePolygon& inside,
           SlicePolygon& outside) {
    inside.count = outside.count = 0;
    for (std::size_t i = 0; i < whole.count; ++i) {
        const glm::dvec2 &corner = whole.corners[i], &following = whole.corners[i + 1 < whole.count ? i + 1 : 0];
        const double here = glm::dot(normal, corner) + offset, there = glm::dot(normal, following) + offset;
        if (here >= 0.0) add(inside, corner);
        if (here <= 0.0) add(outside, corner);
        if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0)) {
            const glm::dvec2 crossing = glm::mix(corner, following, here / (here - there));
            add(inside, crossing);
            add(outside, crossing);
        }
    }
    for (SlicePolygon* part : {&inside, &outside})
        if (part->count < 3 || !(area(*part) > 0.0)) part->count = 0;
}

double area(const SlicePolygon& polygon) {
    double twice = 0.0;
    for (std::size_t i = 2; i < polygon.count; ++i)
        twice += cross(polygon.corners[i - 1] - polygon.corners[0], polygon.corners[i] - polygon.corners[0]);
    return 0.5 * twice;
}

}  // namespace tyndall

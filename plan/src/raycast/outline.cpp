#include "raycast/outline.h"

#include <algorithm>

namespace tyndall {
namespace {

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

// Andrew's monotone chain (Information Processing Letters 9, 1979).
void appendOutline(std::vector<glm::dvec2>& outline, const ConvexPolyhedron& solid, const View& view, double margin) {
    InlineVector<glm::dvec2, 4 * ConvexPolyhedron::maxVertices> points;
    for (const glm::dvec3& vertex : solid.vertices) {
        const glm::dvec4 clip = view.clipFromView * glm::dvec4(vertex, 1.0);
        const glm::dvec2 point = glm::dvec2(clip) / clip.w;
        for (const glm::dvec2 side : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(1, 1)})
            points.push_back(glm::clamp(point + margin * side, -1.0, 1.0));
    }
    std::sort(points.begin(), points.end(),
              [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    const std::size_t start = outline.size();
    const auto extend = [&](const glm::dvec2& point, std::size_t from) {
        while (outline.size() >= from + 2 && turn(outline[outline.size() - 2], outline.back(), point) <= 0.0)
            outline.pop_back();
        outline.push_back(point);
    };
    for (const glm::dvec2& point : points) extend(point, start);
    const std::size_t upper = outline.size() - 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) extend(points[i], upper);
    outline.pop_back();  // the first point again
}

void appendPicture(std::vector<glm::dvec2>& outline) {
    outline.insert(outline.end(), {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}});
}

}  // namespace tyndall

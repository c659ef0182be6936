#include "geometry/convex_polyhedron.h"

#include <algorithm>

namespace tyndall {

ConvexPolyhedron hexahedron(const std::array<glm::dvec3, 8>& corners) {
    ConvexPolyhedron solid;
    for (const glm::dvec3& corner : corners) solid.vertices.push_back(corner);
    solid.faces = 6;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t second = (axis + 1) % 3;
        const std::uint32_t third = (axis + 2) % 3;
        for (std::uint32_t side = 0; side < 4; ++side) {
            const std::uint32_t onSecond = side & 1u;
            const std::uint32_t onThird = side >> 1u;
            const std::uint32_t start = (onSecond << second) | (onThird << third);
            solid.edges.push_back({{start, start | (1u << axis)}, {2 * second + onSecond, 2 * third + onThird}});
        }
    }
    return solid;
}

bool cut(ConvexPolyhedron& solid, const glm::dvec4& plane, double tolerance) {
    constexpr std::uint32_t dropped = ~0u;
    if (solid.vertices.empty()) return false;
    InlineVector<double, ConvexPolyhedron::maxVertices> beyond;
    beyond.resize(solid.vertices.size());
    std::transform(solid.vertices.begin(), solid.vertices.end(), beyond.begin(),
                   [&](const glm::dvec3& p) { return glm::dot(glm::dvec3(plane), p) + plane.w; });
    const auto [min, max] = std::minmax_element(beyond.begin(), beyond.end());
    if (!(*max > tolerance)) return false;
    if (*min >= 0.0) return true;
    if (solid.faces >= ConvexPolyhedron::maxFaces)
        throwCapacityExceeded(ConvexPolyhedron::maxFaces, std::source_location::current());

    ConvexPolyhedron left;
    left.faces = solid.faces + 1;
    const std::uint32_t section = solid.faces;
    InlineVector<std::uint32_t, ConvexPolyhedron::maxVertices> kept;
    kept.resize(solid.vertices.size());
    std::fill(kept.begin(), kept.end(), dropped);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (beyond[i] < 0.0) continue;
        kept[i] = static_cast<std::uint32_t>(left.vertices.size());
        left.vertices.push_back(solid.vertices[i]);
    }
    // The first crossing on each face, until its second.
    std::array<std::uint32_t, ConvexPolyhedron::maxFaces> crossing;
    crossing.fill(dropped);
    for (const ConvexPolyhedron::Edge& edge : solid.edges) {
        auto [inside, outside] = edge.vertices;
        if (kept[inside] == dropped) std::swap(inside, outside);
        if (kept[inside] == dropped) continue;
        if (kept[outside] != dropped) {
            left.edges.push_back({{kept[inside], kept[outside]}, edge.faces});
            continue;
        }
        const auto point = static_cast<std::uint32_t>(left.vertices.size());
        const double share = beyond[inside] / (beyond[inside] - beyond[outside]);
        left.vertices.push_back(glm::mix(solid.vertices[inside], solid.vertices[outside], share));
        left.edges.push_back({{kept[inside], point}, edge.faces});
        for (const std::uint32_t face : edge.faces) {
            if (crossing[face] == dropped) {
                crossing[face] = point;
            } else {
                left.edges.push_back({{crossing[face], point}, {face, section}});
                crossing[face] = dropped;
            }
        }
    }
    solid = left;
    return true;
}

}  // namespace tyndall

// A convex solid that half spaces cut down. It gives the remaining part of a light's volume and its extent. Every edge
// knows its two faces: if a plane crosses two edges of one face, a new edge joins the crossings. Connecting the pieces
// needs no sorting and no tolerance.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "geometry/inline_vector.h"

namespace tyndall {

struct ConvexPolyhedron {
    /// The shape's 6 faces, 6 clip planes, 4 walls, 8 sides of the cookie, 3 depths, 4 sides of the view, 4 sides and
    /// the depth of a tile: 36. By Euler's formula a solid of F faces has at most 2 F - 4 vertices and 3 F - 6 edges.
    static constexpr std::size_t maxFaces = 36, maxVertices = 2 * maxFaces - 4, maxEdges = 3 * maxFaces - 6;
    struct Edge {
        std::array<std::uint32_t, 2> vertices;
        std::array<std::uint32_t, 2> faces;
    };
    InlineVector<glm::dvec3, maxVertices> vertices;
    InlineVector<Edge, maxEdges> edges;
    std::uint32_t faces = 0;
};

/// The solid with the topology of a cube. Bits 0, 1 and 2 of a corner's number select one of two opposite faces, for
/// three such pairs.
ConvexPolyhedron hexahedron(const std::array<glm::dvec3, 8>& corners);

/// Keeps the part with dot(n, p) + d >= 0; the normal has unit length. Returns false, and leaves the solid as it is, if
/// that part is at most `tolerance` metres thick. Throws CapacityExceeded if the solid already has maxFaces.
bool cut(ConvexPolyhedron& solid, const glm::dvec4& plane, double tolerance);

}  // namespace tyndall

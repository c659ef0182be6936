// A convex solid that half spaces cut down, for finding what part of a light's volume is left and how far
// it reaches. Every edge knows its two faces: where a plane crosses two edges of one face it leaves a new
// edge between the crossings, so no sorting and no tolerance decides how the pieces connect.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "geometry/inline_vector.h"

namespace tyndall {

struct ConvexPolyhedron {
    /// A pyramid's 6 faces, 6 clip planes, 4 walls, 8 sides of its cookie, 4 of depth and guard, 8 sides of view and
    /// tile: 36 at most. By Euler's formula a solid of F faces has no more than 2 F - 4 vertices and 3 F - 6 edges.
    static constexpr std::size_t mostFaces = 36, mostVertices = 2 * mostFaces - 4, mostEdges = 3 * mostFaces - 6;
    struct Edge {
        std::array<std::uint32_t, 2> vertices;
        std::array<std::uint32_t, 2> faces;
    };
    InlineVector<glm::dvec3, mostVertices> vertices;
    InlineVector<Edge, mostEdges> edges;
    std::uint32_t faces = 0;
};

/// The solid with the topology of a cube. Bit 0, 1, 2 of a corner's number says on which of two opposite
/// faces it lies, for three such pairs.
ConvexPolyhedron hexahedron(const std::array<glm::dvec3, 8>& corners);

/// Keeps what has dot(n, p) + d >= 0; the normal has unit length. Returns false, leaving the solid as it
/// is, where no more than `tolerance` metres of it lie beyond the plane.
bool cut(ConvexPolyhedron& solid, const glm::dvec4& plane, double tolerance);

}  // namespace tyndall

// Vertices for whatever a vertex shader reads.
#pragma once

#include <permgen/tables.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fixture.h"

namespace tyndall::rig {

/// Vertices by semantic, up to four numbers each, and triangles; clockwise as seen from their front, which is what
/// Direct3D 9 keeps. A built-in shape has POSITION0, NORMAL0, TANGENT0, BINORMAL0, TEXCOORD0 and COLOR0:
/// triangle and quad lie in clip space at depth 0 and fill the picture, cube and sphere reach from -1 to 1.
ExplicitGeometry builtInGeometry(Shape shape);

ExplicitGeometry geometryOf(const Fixture& fixture);

struct VertexAttribute {
    std::string_view semantic;
    std::uint32_t offset = 0;
    VkFormat format = VK_FORMAT_UNDEFINED;
};

/// One interleaved vertex stream.
struct VertexStream {
    std::vector<VertexAttribute> attributes;
    std::uint32_t stride = 0;
    std::vector<std::byte> bytes;
};

/// The stream of `module`'s attributes, each as wide and of the type that it reads; what a vertex does not say is 0,
/// and 1 for a fourth number. Errors: a semantic that the geometry lacks.
Result<VertexStream> vertexStream(const permgen::Module& module, const ExplicitGeometry& geometry);

}  // namespace tyndall::rig

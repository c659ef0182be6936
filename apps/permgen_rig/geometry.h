// Vertices for a vertex shader's inputs.
#pragma once

#include <permgen/tables.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fixture.h"

namespace tyndall::rig {

/// Vertices by semantic, up to four numbers each, and triangles; clockwise as seen from their front, which
/// Direct3D 9 does not cull. A built-in shape has POSITION0, NORMAL0, TANGENT0, BINORMAL0, TEXCOORD0 and COLOR0:
/// triangle and quad lie in clip space at depth 0 and fill the picture, cube and sphere extend from -1 to 1.
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

/// The stream of `module`'s attributes, with their widths and types. Numbers that a vertex lacks are 0, or 1 for the
/// fourth. Errors: a semantic that the geometry lacks.
Result<VertexStream> vertexStream(const permgen::Module& module, const ExplicitGeometry& geometry);

}  // namespace tyndall::rig

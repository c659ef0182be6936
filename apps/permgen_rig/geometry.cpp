#include "geometry.h"

#include <fmt/format.h>
#include <kit/fail.h>

#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <iterator>
#include <numbers>

namespace tyndall::rig {
namespace {

void add(ExplicitGeometry& geometry, glm::dvec3 position, glm::dvec3 normal, glm::dvec3 tangent, glm::dvec2 uv) {
    const glm::dvec3 binormal = glm::cross(normal, tangent);
    const glm::dvec3 colour = 0.5 + 0.5 * position;
    geometry.vertices["POSITION0"].push_back({position.x, position.y, position.z, 1.0});
    geometry.vertices["NORMAL0"].push_back({normal.x, normal.y, normal.z});
    geometry.vertices["TANGENT0"].push_back({tangent.x, tangent.y, tangent.z});
    geometry.vertices["BINORMAL0"].push_back({binormal.x, binormal.y, binormal.z});
    geometry.vertices["TEXCOORD0"].push_back({uv.x, uv.y});
    geometry.vertices["COLOR0"].push_back({colour.x, colour.y, colour.z, 1.0});
}

void addFlat(ExplicitGeometry& geometry, glm::dvec2 corner) {
    // Clip space has y down, as texture space has: the picture's top left corner is (0, 0) of a texture.
    add(geometry, {corner, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 0.5 + 0.5 * corner);
}

ExplicitGeometry cube() {
    ExplicitGeometry geometry;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 normal(0.0), tangent(0.0);
            normal[axis] = side;
            tangent[(axis + 1) % 3] = 1.0;
            // A right-handed frame, seen from outside: tangent to the right, upward up.
            const glm::dvec3 upward = glm::cross(normal, tangent);
            const auto first = static_cast<std::uint32_t>(geometry.vertices["POSITION0"].size());
            for (const glm::dvec2 at : {glm::dvec2(-1, 1), {1, 1}, {1, -1}, {-1, -1}})
                add(geometry, normal + at.x * tangent + at.y * upward, normal, tangent,
                    {0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y});
            for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) geometry.indices.push_back(first + i);
        }
    return geometry;
}

ExplicitGeometry sphere() {
    constexpr std::uint32_t around = 32, down = 16;
    ExplicitGeometry geometry;
    for (std::uint32_t j = 0; j <= down; ++j)
        for (std::uint32_t i = 0; i <= around; ++i) {
            const double u = double(i) / around, v = double(j) / down;
            const double angle = 2.0 * std::numbers::pi * u, polar = std::numbers::pi * v;
            const glm::dvec3 normal(std::sin(polar) * std::sin(angle), std::cos(polar),
                                    std::sin(polar) * std::cos(angle));
            add(geometry, normal, normal, {std::cos(angle), 0.0, -std::sin(angle)}, {u, v});
        }
    for (std::uint32_t j = 0; j < down; ++j)
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = j * (around + 1) + i, b = a + 1, c = a + around + 1, d = c + 1;
            for (const std::uint32_t index : {a, b, d, a, d, c}) geometry.indices.push_back(index);
        }
    return geometry;
}

VkFormat formatOf(const permgen::Attribute& attribute) {
    constexpr std::array floats{VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT, VK_FORMAT_R32G32B32_SFLOAT,
                                VK_FORMAT_R32G32B32A32_SFLOAT};
    constexpr std::array ints{VK_FORMAT_R32_SINT, VK_FORMAT_R32G32_SINT, VK_FORMAT_R32G32B32_SINT,
                              VK_FORMAT_R32G32B32A32_SINT};
    constexpr std::array uints{VK_FORMAT_R32_UINT, VK_FORMAT_R32G32_UINT, VK_FORMAT_R32G32B32_UINT,
                               VK_FORMAT_R32G32B32A32_UINT};
    const std::size_t last = attribute.components - 1;
    switch (attribute.type) {
        case permgen::ScalarType::Int:
            return ints.at(last);
        case permgen::ScalarType::Uint:
        case permgen::ScalarType::Bool:
            return uints.at(last);
        case permgen::ScalarType::Float:
            break;
    }
    return floats.at(last);
}

std::uint32_t attributeBits(permgen::ScalarType type, double value) {
    if (type != permgen::ScalarType::Float) return static_cast<std::uint32_t>(std::llround(value));
    const float number = static_cast<float>(value);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    return bits;
}

}  // namespace

ExplicitGeometry builtInGeometry(Shape shape) {
    ExplicitGeometry geometry;
    switch (shape) {
        case Shape::Triangle:
            for (const glm::dvec2 corner : {glm::dvec2(-1, -1), {3, -1}, {-1, 3}}) addFlat(geometry, corner);
            geometry.indices = {0, 1, 2};
            return geometry;
        case Shape::Quad:
            for (const glm::dvec2 corner : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) addFlat(geometry, corner);
            geometry.indices = {0, 1, 2, 0, 2, 3};
            return geometry;
        case Shape::Cube:
            return cube();
        case Shape::Sphere:
            return sphere();
    }
    return geometry;
}

ExplicitGeometry geometryOf(const Fixture& fixture) {
    if (const auto* shape = std::get_if<Shape>(&fixture.geometry)) return builtInGeometry(*shape);
    return std::get<ExplicitGeometry>(fixture.geometry);
}

Result<VertexStream> vertexStream(const permgen::Module& module, const ExplicitGeometry& geometry) {
    VertexStream stream;
    std::vector<const std::vector<std::vector<double>>*> columns;
    for (const permgen::Attribute& attribute : module.attributes) {
        const auto found = geometry.vertices.find(std::string(attribute.semantic));
        if (found == geometry.vertices.end()) {
            std::vector<std::string> known;
            for (const auto& [semantic, values] : geometry.vertices) known.push_back(semantic);
            return failWith(
                fmt::format("geometry: the vertex shader {} reads {}, but the vertices have {}; give "
                            "\"vertices\" with it",
                            module.name, attribute.semantic, fmt::join(known, ", ")));
        }
        columns.push_back(&found->second);
        stream.attributes.push_back({attribute.semantic, stream.stride, formatOf(attribute)});
        stream.stride += 4 * attribute.components;
    }
    const std::size_t count = geometry.vertices.begin()->second.size();
    for (std::size_t vertex = 0; vertex < count; ++vertex)
        for (std::size_t a = 0; a < columns.size(); ++a) {
            const std::vector<double>& given = (*columns[a])[vertex];
            for (std::uint32_t c = 0; c < module.attributes[a].components; ++c) {
                const double value = c < given.size() ? given[c] : c == 3 ? 1.0 : 0.0;
                const std::uint32_t bits = attributeBits(module.attributes[a].type, value);
                const auto* bytes = reinterpret_cast<const std::byte*>(&bits);
                stream.bytes.insert(stream.bytes.end(), bytes, bytes + sizeof bits);
            }
        }
    return stream;
}

}  // namespace tyndall::rig

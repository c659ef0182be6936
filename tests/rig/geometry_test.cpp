// Properties of the built-in shapes: closed, facing outwards, of the documented size.
#include "geometry.h"

#include <gtest/gtest.h>

#include <cstring>
#include <glm/glm.hpp>

namespace tyndall::rig {
namespace {

glm::dvec3 vector3(const ExplicitGeometry& geometry, const char* semantic, std::uint32_t i) {
    const std::vector<double>& v = geometry.vertices.at(semantic)[i];
    return {v[0], v[1], v[2]};
}

TEST(Geometry, SolidsFaceOutwardsClockwise) {
    for (const Shape shape : {Shape::Cube, Shape::Sphere}) {
        const ExplicitGeometry geometry = builtInGeometry(shape);
        double volume = 0.0;
        for (std::size_t i = 0; i < geometry.indices.size(); i += 3) {
            const glm::dvec3 a = vector3(geometry, "POSITION0", geometry.indices[i]);
            const glm::dvec3 b = vector3(geometry, "POSITION0", geometry.indices[i + 1]);
            const glm::dvec3 c = vector3(geometry, "POSITION0", geometry.indices[i + 2]);
            volume += glm::dot(a, glm::cross(b, c)) / 6.0;
            // Clockwise from outside: the right-hand rule points inwards. At the poles triangles have no area.
            EXPECT_LE(glm::dot(glm::cross(b - a, c - a), a + b + c), 1e-12);
            EXPECT_GT(glm::dot(vector3(geometry, "NORMAL0", geometry.indices[i]), a), 0.9);
        }
        // The divergence theorem: the integral over a closed surface is its volume; a faceted sphere has a little less
        // than 4 pi / 3.
        EXPECT_NEAR(-volume, shape == Shape::Cube ? 8.0 : 4.18879, shape == Shape::Cube ? 1e-12 : 0.1);
    }
}

TEST(Geometry, FramesAreOrthonormal) {
    for (const Shape shape : {Shape::Quad, Shape::Cube, Shape::Sphere}) {
        const ExplicitGeometry geometry = builtInGeometry(shape);
        for (std::uint32_t i = 0; i < geometry.vertices.at("POSITION0").size(); ++i) {
            const glm::dvec3 n = vector3(geometry, "NORMAL0", i), t = vector3(geometry, "TANGENT0", i);
            EXPECT_NEAR(glm::dot(n, n), 1.0, 1e-12);
            EXPECT_NEAR(glm::dot(t, t), 1.0, 1e-12);
            EXPECT_NEAR(glm::dot(n, t), 0.0, 1e-12);
        }
    }
}

// Clockwise on a screen whose y points down means a positive cross product there.
TEST(Geometry, FlatShapesFillThePictureAndFaceTheEye) {
    for (const Shape shape : {Shape::Quad, Shape::Triangle}) {
        const ExplicitGeometry geometry = builtInGeometry(shape);
        double area = 0.0;
        for (std::size_t i = 0; i < geometry.indices.size(); i += 3) {
            const glm::dvec3 a = vector3(geometry, "POSITION0", geometry.indices[i]);
            const glm::dvec3 b = vector3(geometry, "POSITION0", geometry.indices[i + 1]);
            const glm::dvec3 c = vector3(geometry, "POSITION0", geometry.indices[i + 2]);
            const double twice = glm::cross(b - a, c - a).z;
            EXPECT_GT(twice, 0.0);
            area += 0.5 * twice;
        }
        EXPECT_EQ(area, shape == Shape::Quad ? 4.0 : 8.0);
        EXPECT_EQ(geometry.vertices.at("TEXCOORD0")[0], (std::vector<double>{0.0, 0.0}));
    }
}

TEST(Geometry, AStreamIsAsWideAsWhatIsRead) {
    const permgen::Attribute attributes[] = {{"POSITION0", 0, 4, permgen::ScalarType::Float},
                                             {"TEXCOORD0", 1, 2, permgen::ScalarType::Float},
                                             {"BLENDINDICES0", 2, 1, permgen::ScalarType::Int}};
    permgen::Module module{"vs", "main", permgen::Stage::Vertex, {}, {}, attributes};
    ExplicitGeometry geometry;
    geometry.vertices["POSITION0"] = {{1, 2}, {3, 4}, {5, 6}};
    geometry.vertices["TEXCOORD0"] = {{7, 8, 9}, {1, 1, 1}, {1, 1, 1}};
    geometry.vertices["BLENDINDICES0"] = {{-3}, {0}, {0}};
    geometry.indices = {0, 1, 2};
    const auto stream = vertexStream(module, geometry);
    ASSERT_TRUE(stream.has_value()) << stream.error().message;
    EXPECT_EQ(stream->stride, 28u);
    EXPECT_EQ(stream->bytes.size(), 84u);
    float floats[6];
    std::int32_t index = 0;
    std::memcpy(floats, stream->bytes.data(), sizeof floats);
    std::memcpy(&index, stream->bytes.data() + 24, sizeof index);
    EXPECT_EQ(std::vector<float>(floats, floats + 6), (std::vector<float>{1, 2, 0, 1, 7, 8}));
    EXPECT_EQ(index, -3);
    EXPECT_EQ(stream->attributes[2].format, VK_FORMAT_R32_SINT);

    geometry.vertices.erase("TEXCOORD0");
    EXPECT_NE(vertexStream(module, geometry).error().message.find("vs reads TEXCOORD0"), std::string::npos);
}

}  // namespace
}  // namespace tyndall::rig

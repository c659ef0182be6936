// Fixture files: their meaning, and error messages with place and remedy.
#include "fixture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "folder.h"

namespace tyndall::rig {
namespace {

struct FixtureFile : testing::Test {
    test::Folder folder;
    Result<Fixture> read(const std::string& text) {
        test::writeText(folder.at("f.json"), text);
        return readFixture(folder.at("f.json"));
    }
    /// The error message without the file's path.
    std::string errorOf(const std::string& text) {
        const auto fixture = read(text);
        if (fixture) return "no error";
        const std::string start = folder.at("f.json") + ": ";
        EXPECT_EQ(fixture.error().message.substr(0, start.size()), start);
        return fixture.error().message.substr(std::min(start.size(), fixture.error().message.size()));
    }
};

TEST_F(FixtureFile, AnEmptyOneHasDefaults) {
    const auto fixture = read("{}");
    ASSERT_TRUE(fixture.has_value()) << fixture.error().message;
    EXPECT_EQ(fixture->width, 96u);
    EXPECT_EQ(fixture->format, VK_FORMAT_R32G32B32A32_SFLOAT);
    EXPECT_EQ(std::get<Shape>(fixture->geometry), Shape::Quad);
    EXPECT_FALSE(fixture->depth);
}

TEST_F(FixtureFile, EveryFieldIsRead) {
    const auto fixture = read(R"({
        "size": [32, 16], "format": "rgba8", "clear": [0.5, 0.25, 1], "depth": true,
        "constants": {"a": 2, "b": [1, -2.5, 3], "c": [[1, 2], [3, 4]], "d": true},   // comments are fine
        "textures": {"S": {"generate": "checker", "size": [4, 2], "cells": [2, 1], "colours": [[1, 0, 0], [0, 1, 0, 0.5]]},
                     "T": {"image": "pictures/wood.png"}},
        "geometry": {"vertices": {"position": [[0, 0], [1, 0], [0, 1]], "TEXCOORD3": [[1], [2], [3]]}}})");
    ASSERT_TRUE(fixture.has_value()) << fixture.error().message;
    EXPECT_EQ(fixture->height, 16u);
    EXPECT_EQ(fixture->tolerance, Tolerance::Byte);
    EXPECT_EQ(fixture->clear, (std::array<float, 4>{0.5f, 0.25f, 1.0f, 1.0f}));
    EXPECT_EQ(fixture->constants.at("b").values, (std::vector<double>{1.0, -2.5, 3.0}));
    EXPECT_EQ(fixture->constants.at("c").shape, (std::vector<std::size_t>{2, 2}));
    EXPECT_TRUE(fixture->constants.at("a").shape.empty());
    EXPECT_EQ(fixture->constants.at("d").values, (std::vector<double>{1.0}));
    EXPECT_EQ(std::get<Generated>(fixture->textures.at("S")).colours[1][3], 0.5f);
    EXPECT_EQ(std::get<ImageFile>(fixture->textures.at("T")).path, folder.at("pictures/wood.png"));
    const auto& geometry = std::get<ExplicitGeometry>(fixture->geometry);
    EXPECT_EQ(geometry.vertices.at("POSITION0").size(), 3u);
    EXPECT_EQ(geometry.indices, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST_F(FixtureFile, FormatsBringTheirTolerance) {
    EXPECT_EQ(read(R"({"format": "rgba32f"})")->tolerance, Tolerance::Float);
    EXPECT_EQ(read(R"({"format": "rgba16f"})")->tolerance, Tolerance::Half);
}

// Matrices apply in the order in which they are written.
TEST_F(FixtureFile, TransformsMultiplyColumnVectorsFromTheRight) {
    const auto fixture = read(R"({"constants": {
        "m": {"product": [{"translate": [1, 2, 3]}, {"rotate": {"axis": [0, 0, 1], "degrees": 90}}, {"scale": [2, 2, 2]}]},
        "v": {"lookAt": {"eye": [0, 0, 5], "target": [0, 0, 0]}},
        "p": {"perspective": {"fov": 90, "near": 1, "far": 3}}, "i": {"identity": true}}})");
    ASSERT_TRUE(fixture.has_value()) << fixture.error().message;
    const auto apply = [&](const char* name, std::array<double, 4> point) {
        std::array<double, 4> out{};
        for (int row = 0; row < 4; ++row)
            for (int c = 0; c < 4; ++c) out[row] += fixture->constants.at(name).values[4 * row + c] * point[c];
        return out;
    };
    const auto moved = apply("m", {1, 0, 0, 1});  // scaled to (2, 0, 0), turned to (0, 2, 0), moved
    EXPECT_NEAR(moved[0], 1.0, 1e-12);
    EXPECT_NEAR(moved[1], 4.0, 1e-12);
    EXPECT_NEAR(moved[2], 3.0, 1e-12);
    EXPECT_NEAR(apply("v", {0, 0, 0, 1})[2], -5.0, 1e-12);
    // Up is the picture's top, which Vulkan counts as negative; depth runs from 0 to 1.
    const auto high = apply("p", {0, 1, -1, 1}), far = apply("p", {0, 0, -3, 1});
    EXPECT_NEAR(high[1] / high[3], -1.0, 1e-12);
    EXPECT_NEAR(high[2] / high[3], 0.0, 1e-12);
    EXPECT_NEAR(far[2] / far[3], 1.0, 1e-12);
    EXPECT_EQ(apply("i", {1, 2, 3, 4}), (std::array<double, 4>{1, 2, 3, 4}));
}

TEST_F(FixtureFile, MistakesAreAnsweredWithTheirPlace) {
    const std::vector<std::pair<const char*, const char*>> mistakes{
        {R"({"sise": [1, 1]})", R"("sise" has no meaning here; did you mean "size"?)"},
        {R"([])", "this must be an object in braces"},
        {R"({"size": [0, 4]})", "size[0]: this must be a whole number from 1 to 4096, not 0"},
        {R"({"size": [4]})", "size: width and height are 2 numbers, not 1"},
        {R"({"size": 4})", "size: this must be a list in brackets, not 4"},
        {R"({"format": "rgb"})", R"(format: "rgb" is not one of rgba32f, rgba16f, rgba8)"},
        {R"({"clear": [1, 2]})", "clear: a colour has 3 or 4 numbers, not 2"},
        {R"({"depth": 1})", "depth: this must be true or false, not 1"},
        {R"({"constants": {"g": "x"}})", "constants.g: this must be a number"},
        {R"({"constants": {"g": [1, [2]]}})", "constants.g[1]: numbers and lists do not mix"},
        {R"({"constants": {"g": [[1, 2], [3]]}})", "constants.g[1]: lists in a list must have equal lengths"},
        {R"({"constants": {"g": []}})", "constants.g: an empty list"},
        {R"({"constants": {"g": 1e39}})", "constants.g: this must be a number from"},
        {R"({"constants": {"g": {"perspektive": {}}}})", R"(did you mean "perspective"?)"},
        {R"({"constants": {"g": {"perspective": {"fov": 60, "near": 2, "far": 1}}}})",
         R"("far" must be beyond "near")"},
        {R"({"constants": {"g": {"perspective": {"fov": 60, "near": 2}}}})", R"(perspective: "far" is missing)"},
        {R"({"constants": {"g": {"lookAt": {"eye": [0, 1, 0], "target": [0, 0, 0]}}}})", "cannot run along"},
        {R"({"constants": {"g": {"identity": true, "scale": [1, 1, 1]}}})", "put several into \"product\""},
        {R"({"textures": {"S": {"generate": "chequer"}}})", "textures.S.generate: \"chequer\" is not one of"},
        {R"({"textures": {"S": {}}})", R"(textures.S: "generate" is missing)"},
        {R"({"textures": {"S": {"generate": "constant"}}})", "textures.S: a constant texture has"},
        {R"({"textures": {"S": {"generate": "noise", "colours": [[1, 1, 1]]}}})", "2 colour(s) are needed, not 1"},
        {R"({"textures": {"S": {"image": "a.png", "size": [1, 1]}}})",
         R"(a texture with "image" has no other settings)"},
        {R"({"geometry": "torus"})", R"(geometry: "torus" is not one of triangle, quad, cube, sphere)"},
        {R"({"geometry": {"vertices": {}}})", "name at least one semantic"},
        {R"({"geometry": {"vertices": {"POSITION": [[0, 0], [1, 1]]}}})", "geometry: 2 indices do not make triangles"},
        {R"({"geometry": {"vertices": {"POSITION": [[0], [1], [2]], "NORMAL": [[0]]}}})", "give each vertex both"},
        {R"({"geometry": {"vertices": {"POSITION": [[0], [1], [2, 3]]}}})",
         "POSITION[2]: a vertex must have 1 to 4 numbers"},
        {R"({"geometry": {"vertices": {"POSITION": [[0], [1], [2]]}, "indices": [0, 1, 3]}})",
         "indices[2]: this must be a whole"},
        {R"({)", "this is not JSON"},
        {"", "this is not JSON"},
    };
    for (const auto& [text, expected] : mistakes) {
        const std::string message = errorOf(text);
        EXPECT_NE(message.find(expected), std::string::npos) << text << "\n" << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

std::string products(int depth) {
    return R"({"constants": {"g": )" + repeated(R"({"product":[)", depth) + R"({"identity": true})" +
           repeated("]}", depth) + "}}";
}

TEST_F(FixtureFile, ProductsAreNestedSixteenDeepAndNoDeeper) {
    EXPECT_TRUE(read(products(16)).has_value());
    EXPECT_NE(errorOf(products(17)).find("products nest at most 16 deep"), std::string::npos);
}

// Deep enough to overflow the stack of a recursive reader.
TEST_F(FixtureFile, DeepNestingIsRefusedWhereverItStands) {
    const std::string expected = "brackets and braces are nested more than 64 deep";
    constexpr int depth = 200000;
    for (const std::string& text :
         {products(depth), repeated(R"({"product":[)", depth), repeated("[", depth), repeated(R"({"a":)", depth),
          R"({"size": )" + repeated("[", depth) + repeated("]", depth) + "}",
          R"({"format": )" + repeated(R"({"a":)", depth) + "1" + repeated("}", depth) + "}"})
        EXPECT_EQ(errorOf(text).substr(0, expected.size()), expected);
}

TEST_F(FixtureFile, AFolderIsCalledOne) {
    const auto fixture = readFixture(folder.path());
    ASSERT_FALSE(fixture.has_value());
    EXPECT_EQ(fixture.error().message,
              folder.path() + ": this is a folder; name a fixture file, as in " + folder.at("NAME.rig.json"));
}

TEST_F(FixtureFile, AMissingFileIsNamed) {
    EXPECT_EQ(readFixture(folder.at("none.json")).error().message,
              folder.at("none.json") + ": cannot be read; name an existing fixture file");
}

}  // namespace
}  // namespace tyndall::rig

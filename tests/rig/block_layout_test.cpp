// Constants are written where the shader reads them: every type, matrices of both packings, arrays.
#include "block_layout.h"

#include <gtest/gtest.h>
#include <permgen/manifest.h>

#include <cstring>

#include "constants.h"
#include "folder.h"
#include "process.h"

namespace tyndall::rig {
namespace {

constexpr const char* kTypesEffect = R"(
float gOne; float3 gThree; int gCount; uint gMask; bool gOn;
float4x4 gSquare; row_major float4x4 gByRows; float2x3 gWide;
float4 gMany[3]; float gLoose[2];
float4 vs_main(float4 p : POSITION) : POSITION { return p; }
float4 ps_main() : COLOR0
{
    float s = gOne + gThree.x + gCount + gMask + (gOn ? 1.0 : 0.0) + gLoose[1];
    return mul(gSquare, gMany[1]) + mul(gByRows, gMany[2]) + mul(gWide, gThree).xyxy + s;
}
technique t { pass { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_main(); } }
)";

struct BlockLayout : testing::Test {
    test::Folder folder;
    permgen::Result<permgen::LoadedEffect> loaded =
        permgen::load_manifest(test::compileEffect(folder.path(), "types", kTypesEffect));
    const permgen::Effect& effect = loaded.value().tables();
    std::vector<BlockMember> members = blockMembers(effect).value();

    const BlockMember& member(std::string_view name) {
        for (const BlockMember& candidate : members)
            if (candidate.name == name) return candidate;
        throw std::runtime_error("no such member");
    }
    Result<Constants> fill(const std::string& constants) {
        test::writeText(folder.at("f.json"), "{\"constants\": " + constants + "}");
        return fillConstants(effect, members, readFixture(folder.at("f.json")).value());
    }
    template <class T>
    T at(const Constants& constants, std::string_view name, std::size_t offset) {
        T value;
        std::memcpy(&value, constants.blocks.begin()->second.data() + member(name).offset + offset, sizeof value);
        return value;
    }
};

TEST_F(BlockLayout, TypesAreTheAuthors) {
    const std::vector<std::pair<const char*, const char*>> types{
        {"gOne", "float"},     {"gThree", "float3"},    {"gCount", "int"},
        {"gMask", "uint"},     {"gSquare", "float4x4"}, {"gByRows", "float4x4"},
        {"gWide", "float2x3"}, {"gMany", "float4[3]"},  {"gLoose", "float[2]"},
    };
    for (const auto& [name, type] : types) EXPECT_EQ(member(name).typeName(), type) << name;
}

TEST_F(BlockLayout, NumbersLandWhereTheShaderReadsThem) {
    const auto constants = fill(R"({"gOne": 0.5, "gThree": [1, 2, 3], "gCount": -4, "gMask": 4000000000, "gOn": true,
        "gSquare": [[11, 12, 13, 14], [21, 22, 23, 24], [31, 32, 33, 34], [41, 42, 43, 44]],
        "gByRows": [[11, 12, 13, 14], [21, 22, 23, 24], [31, 32, 33, 34], [41, 42, 43, 44]],
        "gWide": [[1, 2, 3], [4, 5, 6]], "gMany": [[1, 2, 3, 4], [5, 6, 7, 8], [9, 10, 11, 12]], "gLoose": [7, 8]})");
    ASSERT_TRUE(constants.has_value()) << constants.error().message;
    EXPECT_TRUE(constants->unset.empty());
    EXPECT_EQ(at<float>(*constants, "gOne", 0), 0.5f);
    EXPECT_EQ(at<float>(*constants, "gThree", 8), 3.0f);
    EXPECT_EQ(at<std::int32_t>(*constants, "gCount", 0), -4);
    EXPECT_EQ(at<std::uint32_t>(*constants, "gMask", 0), 4000000000u);
    EXPECT_EQ(at<std::uint32_t>(*constants, "gOn", 0), 1u);
    // Column-major is HLSL's default: element [row][column] at 16 column + 4 row.
    EXPECT_EQ(at<float>(*constants, "gSquare", 16 * 2 + 4 * 1), 23.0f);
    EXPECT_EQ(at<float>(*constants, "gByRows", 16 * 1 + 4 * 2), 23.0f);
    EXPECT_EQ(at<float>(*constants, "gWide", 16 * 2 + 4 * 1), 6.0f);
    EXPECT_EQ(at<float>(*constants, "gMany", 16 * 1 + 4 * 2), 7.0f);
    EXPECT_EQ(at<float>(*constants, "gLoose", 16), 8.0f);  // an array's elements are 16 bytes apart
}

TEST_F(BlockLayout, WhatIsNotSaidIsZeroAndNamed) {
    const auto constants = fill(R"({"gOne": 1})");
    ASSERT_TRUE(constants.has_value());
    EXPECT_EQ(constants->unset.size(), members.size() - 1);
    EXPECT_EQ(at<float>(*constants, "gThree", 0), 0.0f);
}

TEST_F(BlockLayout, MistakesAreAnsweredWithTypeAndRemedy) {
    const std::vector<std::pair<const char*, const char*>> mistakes{
        {R"({"gTree": 1})", "constants.gTree: types has no such constant; did you mean gThree?"},
        {R"({"gThree": [1, 2]})", "constants.gThree: it is a float3: give 3 numbers, not 2"},
        {R"({"gOne": [1, 2]})", "it is a float: give 1 number, not 2"},
        {R"({"gSquare": [1, 2, 3, 4]})", "it is a float4x4: give 16 numbers, not 4"},
        {R"({"gWide": [[1, 2], [3, 4], [5, 6]]})", "it is a float2x3: the innermost lists have 3 numbers, not 2"},
        {R"({"gCount": 1.5})", "1.5 is not a value of a int"},
        {R"({"gMask": -1})", "-1 is not a value of a uint"},
    };
    for (const auto& [text, expected] : mistakes) {
        const auto constants = fill(text);
        ASSERT_FALSE(constants.has_value()) << text;
        EXPECT_NE(constants.error().message.find(expected), std::string::npos) << constants.error().message;
    }
}

TEST_F(BlockLayout, AnAlteredBlockHasEveryNumberChanged) {
    const auto constants = fill(
        R"({"gOne": 0.5, "gThree": [0, 0.5, 1], "gCount": 1, "gMany": [[0, 0, 0, 0], [1, 1, 1, 1], [2, 2, 2, 2]]})");
    const auto& [name, bytes] = *constants->blocks.begin();
    const std::vector<std::byte> other = altered(members, name, bytes);
    for (const BlockMember& one : members) {
        if (one.name == "gWide") continue;  // the bytes between its columns are not read
        for (std::uint32_t i = 0; i<one.size; i += one.elements> 1 ? one.elementStride : 4)
            EXPECT_NE(std::memcmp(&bytes[one.offset + i], &other[one.offset + i], 4), 0) << one.name << " " << i;
    }
}

}  // namespace
}  // namespace tyndall::rig

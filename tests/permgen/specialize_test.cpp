#include "back/specialize.h"

#include <gtest/gtest.h>

#include <spirv/unified1/spirv.hpp>

#include "back/compile.h"
#include "back/program.h"
#include "back/reflect.h"
#include "back/validate.h"
#include "common/spirv_module.h"
#include "small_effect.h"

namespace permgen {
namespace {

SpirvWords pixel_words(const std::string& body) {
    CompileResult compiled = compile_hlsl(Stage::Pixel, "ps_entry", test::pixel_text(body));
    EXPECT_FALSE(compiled.code.empty()) << compiled.log;
    EXPECT_EQ(validate_spirv(compiled.code), "");
    return compiled.code;
}

std::vector<LoweredConstant> switches(bool noise, bool cookie) {
    return {{"bNoise", 0, ScalarType::Bool, noise}, {"bCookie", 1, ScalarType::Bool, cookie}};
}

Reflection frozen(const SpirvWords& code, const std::vector<LoweredConstant>& constants) {
    const SpecializeResult result = specialize(code, constants);
    EXPECT_EQ(result.reason, "");
    EXPECT_EQ(validate_spirv(result.code), "");
    const ReflectResult reflected = reflect(result.code);
    EXPECT_EQ(reflected.reason, "");
    if (!reflected.reflection) return {};
    EXPECT_TRUE(reflected.reflection->constants.empty()) << "a switch is left";
    return *reflected.reflection;
}

std::string names(const Reflection& reflection) {
    std::string all;
    for (const ReflectedResource& resource : reflection.resources) all += resource.name + " ";
    return all;
}

std::size_t count(const SpirvWords& code, spv::Op opcode) {
    std::size_t found = 0;
    for_each_instruction(code, [&](const SpirvInstruction& instruction) { found += instruction.opcode == opcode; });
    return found;
}

struct Liveness {
    const char* name;
    const char* body;
    const char* live[4];  ///< bNoise + 2 * bCookie
};
void PrintTo(const Liveness& liveness, std::ostream* out) {
    *out << liveness.name;
}

class Live : public testing::TestWithParam<Liveness> {};

TEST_P(Live, IsWhatTheSwitchesLeave) {
    const SpirvWords code = pixel_words(GetParam().body);
    for (unsigned setting = 0; setting < 4; ++setting)
        EXPECT_EQ(names(frozen(code, switches(setting & 1, setting & 2))), GetParam().live[setting])
            << "bNoise " << (setting & 1) << ", bCookie " << (setting >> 1);
}

INSTANTIATE_TEST_SUITE_P(
    Specialize, Live,
    testing::Values(Liveness{"Branches",
                             "float4 c = gTint[0];\n"
                             "if (bNoise) c *= tex3D(NoiseSampler, at).r;\n"
                             "if (bCookie) c *= tex2D(CookieSampler, uv.xy);\n"
                             "return c;\n",
                             {"Globals ", "Globals NoiseSampler ", "Globals CookieSampler ",
                              "Globals CookieSampler NoiseSampler "}},
                    Liveness{"Selections",
                             "float4 c = bNoise ? tex3D(NoiseSampler, at) : float4(1.0, 1.0, 1.0, 1.0);\n"
                             "float k = bCookie ? tex2D(CookieSampler, uv.xy).r : 1.0;\n"
                             "return c * k;\n",
                             {"", "NoiseSampler ", "CookieSampler ", "CookieSampler NoiseSampler "}},
                    Liveness{"SelectionGuardsSelection",
                             "float k = bNoise ? 1.0 : 0.0;\n"
                             "float4 c = k > 0.5 ? tex3D(NoiseSampler, at) : float4(0.5, 0.5, 0.5, 0.5);\n"
                             "return bCookie ? c * tex2D(CookieSampler, uv.xy) : c;\n",
                             {"", "NoiseSampler ", "CookieSampler ", "CookieSampler NoiseSampler "}},
                    Liveness{"WithSomethingDynamic",
                             "float4 c = uv;\n"
                             "if (bNoise && uv.x > 0.5) c *= tex3D(NoiseSampler, at).r;\n"
                             "if (bCookie || uv.y > 0.5) c *= tex2D(CookieSampler, uv.xy);\n"
                             "return c;\n",
                             {"CookieSampler ", "CookieSampler NoiseSampler ", "CookieSampler ",
                              "CookieSampler NoiseSampler "}},
                    Liveness{"BothTogether",
                             "float4 c = uv;\n"
                             "if (bNoise && bCookie) c *= tex3D(NoiseSampler, at).r;\n"
                             "if (!bNoise && !bCookie) c *= tex2D(CookieSampler, uv.xy);\n"
                             "return c;\n",
                             {"CookieSampler ", "", "", "NoiseSampler "}},
                    Liveness{"EarlyReturn",
                             "if (!bCookie) return uv;\n"
                             "float4 c = tex2D(CookieSampler, uv.xy);\n"
                             "if (bNoise) return c * tex3D(NoiseSampler, at).r;\n"
                             "return c;\n",
                             {"", "", "CookieSampler ", "CookieSampler NoiseSampler "}},
                    Liveness{"Loops",
                             "float4 c = uv;\n"
                             "for (int i = 0; i < (bNoise ? 4 : 0); ++i) c += tex3D(NoiseSampler, at * i);\n"
                             "[unroll] for (int k = 0; k < 2; ++k) if (bCookie) c += tex2D(CookieSampler, uv.xy * k);\n"
                             "return c;\n",
                             {"", "NoiseSampler ", "CookieSampler ", "CookieSampler NoiseSampler "}},
                    Liveness{"Discard",
                             "if (bNoise && tex3D(NoiseSampler, at).r < 0.5) discard;\n"
                             "if (bCookie) clip(tex2D(CookieSampler, uv.xy).r - 0.5);\n"
                             "return uv;\n",
                             {"", "NoiseSampler ", "CookieSampler ", "CookieSampler NoiseSampler "}},
                    Liveness{"LocalArray",
                             "float4 c[2];\n"
                             "c[0] = bNoise ? tex3D(NoiseSampler, at) : uv;\n"
                             "c[1] = bCookie ? tex2D(CookieSampler, uv.xy) : uv;\n"
                             "return c[0] + c[1];\n",
                             {"", "NoiseSampler ", "CookieSampler ", "CookieSampler NoiseSampler "}},
                    Liveness{"ComputedAndDropped",
                             "float4 c = tex3D(NoiseSampler, at);\n"
                             "float4 d = tex2D(CookieSampler, uv.xy);\n"
                             "if (!bNoise) c = uv;\n"
                             "if (!bCookie) d = uv;\n"
                             "return c + d;\n",
                             {"", "NoiseSampler ", "CookieSampler ", "CookieSampler NoiseSampler "}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(Specialize, InputsThatAreNoLongerReadDisappear) {
    const SpirvWords code = pixel_words("return bNoise ? float4(at, 1.0) : uv;\n");
    const Reflection with = frozen(code, switches(true, false));
    ASSERT_EQ(with.inputs.size(), 1u);
    EXPECT_EQ(with.inputs[0].location, 1u);
    const Reflection without = frozen(code, switches(false, false));
    ASSERT_EQ(without.inputs.size(), 1u);
    EXPECT_EQ(without.inputs[0].location, 0u);
}

TEST(Specialize, OutputsAllStay) {
    const std::string text =
        "struct O { [[vk::location(0)]] float4 a : TEXCOORD0; [[vk::location(4)]] float4 b : TEXCOORD1;\n"
        "           float4 position : SV_Position; float4 clip : SV_ClipDistance0; };\n"
        "O vs_entry([[vk::location(0)]] float4 p : POSITION) { O o = (O)0; o.position = p; o.clip = p; return o; }\n";
    const CompileResult compiled = compile_hlsl(Stage::Vertex, "vs_entry", text);
    ASSERT_FALSE(compiled.code.empty()) << compiled.log;
    const Reflection reflection = frozen(compiled.code, {});
    ASSERT_EQ(reflection.outputs.size(), 4u);
    EXPECT_EQ(reflection.outputs[1].location, 4u);
}

// (x * 2) * 3 and x * 6 differ in the last bit for some x: then frozen and specialized pipelines would differ, too.
TEST(Specialize, ArithmeticIsNotReassociated) {
    const SpirvWords code = pixel_words("float x = uv.x * 2.1; x = x * 3.3; x = x + 0.0; return x / 7.0;\n");
    const SpecializeResult result = specialize(code, switches(false, false));
    EXPECT_EQ(count(result.code, spv::OpFMul), 2u);
    EXPECT_EQ(count(result.code, spv::OpFAdd), 1u);
    EXPECT_EQ(count(result.code, spv::OpFDiv), 1u);
}

TEST(Specialize, NothingDeadIsLeft) {
    const SpirvWords code = pixel_words("float4 c = uv; if (bNoise) c *= tex3D(NoiseSampler, at).r; return c;\n");
    const SpecializeResult result = specialize(code, switches(false, false));
    EXPECT_EQ(count(result.code, spv::OpFunction), 1u);
    EXPECT_EQ(count(result.code, spv::OpVariable), 2u);  // what is read and what is written
    EXPECT_EQ(count(result.code, spv::OpBranchConditional), 0u);
    EXPECT_EQ(count(result.code, spv::OpTypeImage), 0u);
    EXPECT_EQ(count(result.code, spv::OpSpecConstantFalse) + count(result.code, spv::OpSpecConstantTrue), 0u);
}

TEST(Specialize, NumbersBecomeWhatTheyAreSetTo) {
    const std::string text =
        "[[vk::constant_id(3)]] const int steps = 2; [[vk::constant_id(4)]] const float gain = 0.5;\n"
        "[[vk::constant_id(5)]] const uint mode = 0; sampler2D map;\n"
        "float4 f(float2 t, int n, float g, uint m) {\n"
        "    float4 c = g; for (int i = 0; i < n; ++i) c += tex2D(map, t * i); return m == 2 ? c : float4(g, g, g, g); "
        "}\n"
        "float4 ps_entry([[vk::location(0)]] float2 t : TEXCOORD0) : SV_Target0 { return f(t, steps, gain, mode); }\n";
    const CompileResult compiled = compile_hlsl(Stage::Pixel, "ps_entry", text);
    ASSERT_FALSE(compiled.code.empty()) << compiled.log;
    const auto with = [&](std::uint32_t steps, std::uint32_t mode) {
        return names(frozen(compiled.code, {{"steps", 3, ScalarType::Int, steps},
                                            {"gain", 4, ScalarType::Float, 0x3f800000u},
                                            {"mode", 5, ScalarType::Uint, mode}}));
    };
    EXPECT_EQ(with(4, 2), "map ");
    EXPECT_EQ(with(4, 1), "");
    EXPECT_EQ(with(0xffffffffu, 2), "");  // -1: the loop is never entered
}

TEST(Specialize, TheSameTwice) {
    const SpirvWords code = pixel_words("float4 c = uv; if (bNoise) c *= tex3D(NoiseSampler, at).r; return c;\n");
    EXPECT_EQ(specialize(code, switches(true, false)).code, specialize(code, switches(true, false)).code);
}

TEST(Specialize, WhatIsNoSpirvFailsWithAReason) {
    const SpirvWords junk(20, 7);
    const SpecializeResult result = specialize(junk, {});
    EXPECT_TRUE(result.code.empty());
    EXPECT_NE(result.reason, "");
}

TEST(Validate, TellsWhatIsWrong) {
    SpirvWords code = pixel_words("return uv;\n");
    EXPECT_EQ(validate_spirv(code), "");
    code.resize(code.size() - 1);  // the last OpFunctionEnd
    EXPECT_NE(validate_spirv(code), "");
    EXPECT_NE(validate_spirv({}), "");
}

}  // namespace
}  // namespace permgen

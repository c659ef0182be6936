#include "small_effect.h"

#include <algorithm>

namespace permgen::test {
namespace {

// Nine lines, so that the text after them starts on line 10.
constexpr const char* declarations = R"([[vk::binding(0, 0)]] cbuffer Globals
{
    float4x4 gClipFromView;
    float4 gTint[2];
    float gGain;
    float3 gOffset;
};
[[vk::binding(1, 0)]] sampler2D CookieSampler;
[[vk::binding(2, 0)]] sampler3D NoiseSampler;
)";

constexpr const char* vertex = R"(struct Point
{
    [[vk::location(0)]] float4 uv : TEXCOORD0;
    [[vk::location(1)]] float3 at : TEXCOORD1;
    float4 position : SV_Position;
};
Point vs_entry([[vk::location(0)]] float3 p : POSITION0)
{
    Point o;
    o.position = mul(gClipFromView, float4(p, 1.0));
    o.uv = float4(p.xy, 0.0, 1.0);
    o.at = p + gOffset;
    return o;
}
)";

constexpr const char* pixel_body = R"(    float4 c = gTint[1] * gGain;
    if (bCookie) c *= tex2D(CookieSampler, uv.xy / uv.w);
    c.a = bNoise ? tex3D(NoiseSampler, at).r : 1.0;
    return c;
)";

std::vector<SourceLocation> places_of(const std::string& text) {
    std::vector<SourceLocation> places;
    const int lines = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
    for (int line = 1; line <= lines; ++line) places.push_back({"small.fx", line, 0});
    return places;
}

}  // namespace

std::string pixel_text(const std::string& body) {
    return declarations + std::string("float4 ps_main(float4 uv, float3 at, bool bNoise, bool bCookie) {\n") + body +
           R"(}
[[vk::constant_id(0)]] const bool axis_0 = false;
[[vk::constant_id(1)]] const bool axis_1 = false;
float4 ps_entry([[vk::location(0)]] float4 uv : TEXCOORD0, [[vk::location(1)]] float3 at : TEXCOORD1) : SV_Target0
{
    return ps_main(uv, at, axis_0, axis_1);
}
)";
}

Lowered small_effect() {
    Lowered effect;
    effect.name = "small";
    effect.dependencies = {"small.fx"};
    effect.resources = {{"Globals",
                         ResourceKind::UniformBuffer,
                         ImageDimension::None,
                         0,
                         0,
                         {},
                         ImageFormat::None,
                         false,
                         {"small.fx", 1, 1}},
                        {"CookieSampler",
                         ResourceKind::CombinedImageSampler,
                         ImageDimension::Two,
                         0,
                         1,
                         {{"MinFilter", "LINEAR", StateId::MinFilter, 0, ValueKind::Enum, 2},
                          {"AddressU", "CLAMP", StateId::AddressU, 0, ValueKind::Enum, 3}},
                         ImageFormat::None,
                         false,
                         {"small.fx", 8, 1}},
                        {"NoiseSampler",
                         ResourceKind::CombinedImageSampler,
                         ImageDimension::Three,
                         0,
                         2,
                         {},
                         ImageFormat::None,
                         false,
                         {"small.fx", 9, 1}}};

    LoweredModule vs{
        "vs_main", "vs_entry", "vs_main", Stage::Vertex,      {}, "vs_3_0", declarations + std::string(vertex), {},
        {},        {},         {},        {"small.fx", 16, 7}};
    vs.line_map = places_of(vs.hlsl);
    vs.inputs = {{"POSITION0", false, 0, 3, ScalarType::Float, {}}};
    vs.outputs = {{"TEXCOORD0", false, 0, 4, ScalarType::Float, {}},
                  {"TEXCOORD1", false, 1, 3, ScalarType::Float, {}},
                  {"SV_POSITION", true, 0, 4, ScalarType::Float, {}}};

    LoweredModule ps{"ps_main", "ps_entry", "ps_main", Stage::Pixel,       {}, "ps_3_0", pixel_text(pixel_body), {},
                     {},        {},         {},        {"small.fx", 10, 8}};
    ps.line_map = places_of(ps.hlsl);
    ps.axes = {{"bNoise", 0, ScalarType::Bool, 0, {}}, {"bCookie", 1, ScalarType::Bool, 0, {}}};
    ps.inputs = {{"TEXCOORD0", false, 0, 4, ScalarType::Float, {}}, {"TEXCOORD1", false, 1, 3, ScalarType::Float, {}}};
    ps.outputs = {{"COLOR0", false, 0, 4, ScalarType::Float, {}}};
    effect.modules = {vs, ps};

    const auto pass = [](std::uint32_t noise, std::uint32_t cookie, int line) {
        LoweredPass p{
            "p0", {0, {}, {"small.fx", line, 30}}, {1, {}, {"small.fx", line, 60}}, {}, {}, {"small.fx", line, 1}};
        p.pixel.constants = {{"bNoise", 0, ScalarType::Bool, noise}, {"bCookie", 1, ScalarType::Bool, cookie}};
        p.states = {{"SrcBlend", "ONE", StateId::SrcBlend, 0, ValueKind::Enum, 2},
                    {"DestBlend", "ONE", StateId::DestBlend, 0, ValueKind::Enum, 2}};
        return p;
    };
    effect.techniques = {{"plain", {pass(0, 0, 40)}, {"small.fx", 40, 1}},
                         {"patterned", {pass(0, 1, 41)}, {"small.fx", 41, 1}}};
    return effect;
}

}  // namespace permgen::test

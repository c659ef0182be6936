// Every error about compute shaders, with its place.
#include <gtest/gtest.h>

#include <algorithm>

#include "lowered_text.h"

namespace permgen {
namespace {

struct ErrorCase {
    const char* name;
    const char* code;
    std::string text;  ///< '@' marks the place
    const char* says;
};
void PrintTo(const ErrorCase& error, std::ostream* out) {
    *out << error.name;
}

class ComputeError : public testing::TestWithParam<ErrorCase> {};

TEST_P(ComputeError, HasItsPlace) {
    std::string text = GetParam().text;
    const std::size_t at = text.find('@');
    ASSERT_NE(at, std::string::npos);
    text.erase(at, 1);
    const test::LoweredEffect result(text);
    const auto found = std::find_if(result.diagnostics.begin(), result.diagnostics.end(), [&](const Diagnostic& said) {
        return said.severity == Severity::Error && said.code == GetParam().code;
    });
    ASSERT_NE(found, result.diagnostics.end()) << result.messages();
    EXPECT_NE(found->message.find(GetParam().says), std::string::npos) << found->message;
    for (const std::string code : {"PG028", "PG029", "PG041", "PG047", "PG048"})
        if (code == found->code) {
            EXPECT_NE(found->message.find("; "), std::string::npos) << "no remedy: " << found->message;
        }
    EXPECT_EQ(found->place.line, 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    const std::size_t line_start = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    EXPECT_EQ(found->place.column, static_cast<int>(at - (line_start == std::string::npos ? 0 : line_start + 1)) + 1);
    EXPECT_EQ(std::count_if(result.diagnostics.begin(), result.diagnostics.end(),
                            [](const Diagnostic& said) { return said.severity == Severity::Error; }),
              1)
        << result.messages();
}

std::string passed(const std::string& content) {
    return "\ntechnique t { pass p { " + content + " } }";
}
const std::string plain_pass = passed("ComputeShader = compile cs_5_0 cs();");
const std::string old_pass = passed("ComputeShader = compile cs_4_1 cs();");
const std::string pixel_pass = "\nfloat4 vs(float4 p : POSITION) : POSITION { return p; }" +
                               passed("VertexShader = compile vs_3_0 vs(); PixelShader = compile ps_3_0 ps();");

std::string group(const std::string& sizes) {
    return "[" + sizes + "]\nvoid cs() {}" + plain_pass;
}
std::string entry(const std::string& parameters) {
    return "[numthreads(1, 1, 1)]\nvoid cs(" + parameters + ") {}" + plain_pass;
}
std::string body(const std::string& globals, const std::string& statement) {
    return globals + "\n[numthreads(1, 1, 1)]\nvoid cs(uint3 id : SV_DispatchThreadID) {\n" + statement + "\n}" +
           plain_pass;
}
std::string pixel(const std::string& globals, const std::string& statement) {
    return globals + "\nfloat4 ps() : COLOR {\n" + statement + "\nreturn 1; }" + pixel_pass;
}

INSTANTIATE_TEST_SUITE_P(
    Passes, ComputeError,
    testing::Values(
        ErrorCase{"VertexProfile", "PG024", passed("ComputeShader = compile @vs_3_0 cs();"), "; write cs_5_0"},
        ErrorCase{"PixelProfile", "PG024", passed("ComputeShader = compile @ps_3_0 cs();"), "for a ComputeShader"},
        ErrorCase{"ComputeInPixel", "PG024", passed("PixelShader = compile @cs_5_0 ps();"), "; write ps_3_0"},
        ErrorCase{"ComputeInVertex", "PG024", passed("VertexShader = compile @cs_4_0 vs();"), "; write vs_3_0"},
        ErrorCase{"Typo", "PG024", passed("ComputeShader = compile @cz_5_0 cs();"), "; did you mean 'cs_5_0'?"},
        ErrorCase{"Twice", "PG025",
                  passed("ComputeShader = compile cs_5_0 cs(); @ComputeShader = compile cs_5_0 cs();"),
                  "sets ComputeShader twice"},
        ErrorCase{"WithVertex", "PG028",
                  "[numthreads(1, 1, 1)] void cs() {} float4 vs(float4 p : POSITION) : POSITION { return p; }" +
                      passed("VertexShader = compile vs_3_0 vs(); ComputeShader = @compile cs_5_0 cs();"),
                  "has a ComputeShader and a VertexShader"},
        ErrorCase{"WithPixel", "PG028",
                  "[numthreads(1, 1, 1)] void cs() {} float4 ps() : COLOR { return 1; }" +
                      passed("ComputeShader = @compile cs_5_0 cs(); PixelShader = compile ps_3_0 ps();"),
                  "has a ComputeShader and a PixelShader"},
        ErrorCase{"Assembly", "PG026", passed("ComputeShader = @asm { };"), "is not supported"},
        ErrorCase{"AtFileScope", "PG022", "@ComputeShader c = compile cs_5_0 cs();" + plain_pass,
                  "write the `compile` into the pass"}),
    [](const auto& error) { return std::string(error.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Groups, ComputeError,
    testing::Values(
        ErrorCase{"Missing", "PG029", "void @cs() {}" + plain_pass, "has no thread group; write [numthreads(X, Y, Z)]"},
        ErrorCase{"Two", "PG029", group("@numthreads(8, 8)"), "takes three sizes, not 2"},
        ErrorCase{"Four", "PG029", group("@numthreads(1, 1, 1, 1)"), "takes three sizes, not 4"},
        ErrorCase{"None", "PG029", group("@numthreads()"), "takes three sizes, not 1"},
        ErrorCase{"Empty", "PG029", group("@numthreads(8, , 1)"), "the y size of [numthreads] is missing"},
        ErrorCase{"Zero", "PG029", group("numthreads(8, @0, 1)"), "the y size of [numthreads] is '0'"},
        ErrorCase{"Negative", "PG029", group("numthreads(@-8, 8, 1)"), "'-8'"},
        ErrorCase{"Huge", "PG029", group("numthreads(8, 8, @99999999999999999999)"), "z size of [numthreads]"},
        ErrorCase{"Wraps", "PG029", group("numthreads(@4294967297, 1, 1)"), "is out of range"},
        ErrorCase{"Float", "PG029", group("numthreads(@8.0, 8, 1)"), "is a float"},
        ErrorCase{"Bool", "PG029", group("numthreads(@true, 8, 1)"), "is a bool"},
        ErrorCase{"Name", "PG029", "static const int n = 8;\n" + group("numthreads(@n, 8, 1)"), "is not a literal"},
        ErrorCase{"Sum", "PG029", group("numthreads(@4 + 4, 8, 1)"), "is not a literal"},
        ErrorCase{"WideX", "PG029", group("numthreads(@1025, 1, 1)"), "from 1 to 1024, as cs_5 allows"},
        ErrorCase{"DeepZ", "PG029", group("numthreads(1, 1, @65)"), "from 1 to 64, as cs_5 allows"},
        ErrorCase{"Many", "PG029", group("@numthreads(32, 32, 2)"), "groups of 2048 threads, and cs_5 allows 1024"},
        ErrorCase{"OldDeep", "PG029", "[numthreads(1, 1, @2)] void cs() {}" + old_pass, "from 1 to 1, as cs_4 allows"},
        ErrorCase{"OldMany", "PG029", "[@numthreads(32, 32, 1)] void cs() {}" + old_pass, "cs_4 allows 768"},
        ErrorCase{"GivenTwice", "PG029", "[numthreads(1, 1, 1)]\n" + group("@numthreads(1, 1, 1)"), "remove one"},
        ErrorCase{"OnAVariable", "PG029", "[@numthreads(1, 1, 1)] float x;\n" + group("numthreads(1, 1, 1)"),
                  "belongs in front of a function"}),
    [](const auto& error) { return std::string(error.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Interface, ComputeError,
    testing::Values(
        ErrorCase{"Texcoord", "PG035", entry("float2 t : @TEXCOORD0"), "a compute shader reads SV_DispatchThreadID"},
        ErrorCase{"Position", "PG035", entry("uint4 t : @SV_Position"), "cannot be a compute shader's input"},
        ErrorCase{"VertexId", "PG035", entry("uint t : @SV_VertexID"), "cannot be a compute shader's input"},
        ErrorCase{"Index", "PG035", entry("uint3 t : @SV_GroupID1"), "'SV_GROUPID1' cannot be"},
        ErrorCase{"NoSemantic", "PG034", entry("uint3 @t"), "such as ': SV_DispatchThreadID'"},
        ErrorCase{"Float", "PG037", entry("float3 @t : SV_DispatchThreadID"), "'t' must be a uint3"},
        ErrorCase{"Wide", "PG037", entry("uint2 @t : SV_GroupIndex"), "'t' must be a uint to be SV_GROUPINDEX"},
        ErrorCase{"Twice", "PG036", entry("uint3 a : SV_GroupID, uint3 @b : SV_GroupID"), "is given twice"},
        ErrorCase{"Out", "PG035", entry("out float4 @c : COLOR"), "cannot be a compute shader's output"},
        ErrorCase{"Result", "PG035", "[numthreads(1, 1, 1)]\nfloat4 @cs() : COLOR { return 1; }" + plain_pass,
                  "returns a value; make it void"},
        ErrorCase{"InPixel", "PG035", "float4 ps(uint3 i : @SV_GroupID) : COLOR { return 1; }" + pixel_pass,
                  "cannot be a pixel shader's input"}),
    [](const auto& error) { return std::string(error.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Storage, ComputeError,
    testing::Values(
        ErrorCase{"Float3", "PG041", body("RWTexture2D<@float3> i;", ""), "with 1, 2 or 4 components"},
        ErrorCase{"Matrix", "PG041", body("RWTexture2D<@float2x2> i;", ""), "cannot hold 'float2x2'"},
        ErrorCase{"BoolImage", "PG041", body("RWTexture2D<@bool> i;", ""), "cannot hold 'bool'"},
        ErrorCase{"Unorm", "PG041", body("RWTexture2D<@unorm float4> i;", ""),
                  "; write [[vk::image_format(\"rgba8\")]] RWTexture2D<float4>"},
        ErrorCase{"Snorm", "PG041", body("RWTexture2D<@snorm float4> i;", ""), "image_format(\"rgba8snorm\")]]"},
        ErrorCase{"RowMajor", "PG041", body("StructuredBuffer<@row_major float3x3> i;", ""), "write the plain type"},
        ErrorCase{"StructImage", "PG041", body("struct S { float a; }; RWTexture2D<@S> i;", ""), "cannot hold 'S'"},
        ErrorCase{"UnknownElement", "PG041", body("StructuredBuffer<@S> i;", ""), "cannot hold 'S'"},
        ErrorCase{"Double", "PG041", body("StructuredBuffer<@double> i;", ""), "cannot hold 'double'"},
        ErrorCase{"BoolBuffer", "PG041", body("RWStructuredBuffer<@bool> i;", ""), "; write uint"},
        ErrorCase{"BoolMember", "PG041", body("struct S { float a; @bool b; }; StructuredBuffer<S> i;", ""),
                  "; write uint"},
        ErrorCase{"SamplerMember", "PG041", body("struct S { @sampler2D s; }; StructuredBuffer<S> i;", ""),
                  "cannot hold 'sampler2D'"},
        ErrorCase{"BytesOfType", "PG041", body("ByteAddressBuffer@<uint> i;", ""), "has no element type"},
        ErrorCase{"Array", "PG022", body("RWTexture2D<float> i@[4];", ""), "declare each by its own name"},
        ErrorCase{"Initial", "PG022", body("RWStructuredBuffer<float> @i = 4;", ""), "cannot have an initial value"},
        ErrorCase{"Texel", "PG022", body("@RWBuffer<float> i;", ""), "; use a RWStructuredBuffer"},
        ErrorCase{"Append", "PG022", body("@AppendStructuredBuffer<float> i;", ""), "count with InterlockedAdd"},
        ErrorCase{"ImageArray", "PG022", body("@RWTexture2DArray<float> i;", ""), "; use a RWTexture3D"},
        ErrorCase{"Coherent", "PG022", body("@globallycoherent RWTexture2D<float> i;", ""), "is not supported"},
        ErrorCase{"Parameter", "PG041", "void f(@RWTexture2D<float> i) {}" + body("", ""), "at file scope; use"},
        ErrorCase{"Member", "PG041", "struct S { @ByteAddressBuffer b; };" + body("", ""), "at file scope; use"},
        ErrorCase{"Local", "PG041", body("RWTexture2D<float> i;", "@RWTexture2D<float> j = i;"), "at file scope; use"},
        ErrorCase{"NameTwice", "PG023", body("float i; ByteAddressBuffer @i;", ""), "is declared twice"},
        ErrorCase{"SharedInitial", "PG022", body("groupshared float @f = 1;", ""), "cannot have an initial value"},
        ErrorCase{"SharedStatic", "PG022", body("@static groupshared float f;", ""), "neither static nor const"},
        ErrorCase{"SharedParameter", "PG022", "void f(@groupshared float x) {}" + body("", ""),
                  "at file scope; declare"},
        ErrorCase{"SharedMember", "PG022", "struct S { @groupshared float x; };" + body("", ""), "at file scope; "}),
    [](const auto& error) { return std::string(error.param.name); });

std::string formatted(const std::string& name, const std::string& declaration) {
    return body("[[vk::image_format(" + name + ")]] " + declaration, "");
}

INSTANTIATE_TEST_SUITE_P(
    Formats, ComputeError,
    testing::Values(
        ErrorCase{"Misspelt", "PG041", formatted("@\"rgba15f\"", "RWTexture2D<float4> i;"), "did you mean 'rgba16f'?"},
        ErrorCase{"Empty", "PG041", formatted("@\"\"", "RWTexture2D<float4> i;"), "; write one such as rgba16f"},
        ErrorCase{"Unknown", "PG041", formatted("@\"unknown\"", "RWTexture2D<float4> i;"), "is not an image format"},
        ErrorCase{"NoQuotes", "PG041", formatted("@rgba16f", "RWTexture2D<float4> i;"), "the format's name in quotes"},
        ErrorCase{"NoName", "PG041", formatted("@", "RWTexture2D<float4> i;"), "the format's name in quotes"},
        ErrorCase{"Components", "PG041", formatted("\"rg16f\"", "RWTexture2D<@float4> i;"),
                  "a RWTexture2D of rg16f cannot hold 'float4'; write RWTexture2D<float2>"},
        ErrorCase{"Scalar", "PG041", formatted("\"r16ui\"", "RWTexture3D<@int> i;"), "; write RWTexture3D<uint>"},
        ErrorCase{"Bool", "PG041", formatted("\"r8ui\"", "RWTexture2D<@bool> i;"), "; write RWTexture2D<uint>"},
        ErrorCase{"Float3", "PG041", formatted("\"rgba8\"", "RWTexture2D<@float3> i;"), "; write RWTexture2D<float4>"},
        ErrorCase{"Buffer", "PG041", formatted("@\"r32f\"", "RWStructuredBuffer<float> i;"), "has no image format"},
        ErrorCase{"Bytes", "PG041", formatted("@\"r32f\"", "ByteAddressBuffer i;"), "has no image format; remove"},
        ErrorCase{"Variable", "PG041", formatted("@\"r32f\"", "float4 i;"), "belongs in front of a RWTexture1D"},
        ErrorCase{"Function", "PG041", formatted("@\"r32f\"", "void f() {}"), "belongs in front of a RWTexture1D"},
        ErrorCase{"Twice", "PG041",
                  body("[[vk::image_format(\"r32f\")]] [[vk::@image_format(\"r32f\")]] RWTexture2D<float> i;", ""),
                  "is given twice; remove one"},
        ErrorCase{"RefusedType", "PG022", formatted("\"r32f\"", "@RWTexture2DArray<float> i;"), "; use a RWTexture3D"},
        ErrorCase{"OwnBinding", "PG022", body("@[[vk::binding(3, 0)]] RWTexture2D<float4> i;", ""),
                  "permgen gives out"},
        ErrorCase{"Unclosed", "PG020", body("[[vk::image_format(\"r32f\")] @RWTexture2D<float> i;", ""),
                  "expected ']'"}),
    [](const auto& error) { return std::string(error.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Uses, ComputeError,
    testing::Values(
        ErrorCase{"StoreReadOnly", "PG047", body("ByteAddressBuffer b;", "b.@Store(0, 1u);"), "as RWByteAddressBuffer"},
        ErrorCase{"AtomicMethodReadOnly", "PG047", body("ByteAddressBuffer b;", "uint o; b.@InterlockedAdd(0, 1u, o);"),
                  "cannot be written"},
        ErrorCase{"AtomicReadOnly", "PG047", body("StructuredBuffer<uint> b;", "InterlockedAdd(@b[0], 1u);"),
                  "as RWStructuredBuffer"},
        ErrorCase{"AtomicOfAShortTexel", "PG047",
                  body("[[vk::image_format(\"r16ui\")]] RWTexture2D<uint> i;", "InterlockedAdd(@i[id.xy], 1u);"),
                  "needs texels of r32i or r32ui; declare 'i' as RWTexture2D<int> or RWTexture2D<uint>"},
        ErrorCase{"AtomicLocal", "PG047", body("", "uint n = 0; InterlockedAdd(@n, 1u);"),
                  "needs a groupshared variable"},
        ErrorCase{"AtomicShadowed", "PG047", body("groupshared uint n;", "uint n = 0; InterlockedAdd(@n, 1u);"),
                  "needs a groupshared variable"},
        ErrorCase{"CompareStore", "PG047", body("groupshared uint n;", "@InterlockedCompareStore(n, 1u, 2u);"),
                  "; write InterlockedCompareExchange"},
        ErrorCase{"CompareStoreMethod", "PG047",
                  body("RWByteAddressBuffer b;", "b.@InterlockedCompareStore(0, 1u, 2u);"),
                  "; write InterlockedCompareExchange"},
        ErrorCase{"Counter", "PG047", body("RWStructuredBuffer<uint> b;", "b[b.@IncrementCounter()] = 1;"),
                  "count with InterlockedAdd"},
        ErrorCase{"InoutTexel", "PG047",
                  "void f(inout float x) { x += 1; }\n" + body("RWTexture2D<float> i;", "f(@i[id.xy]);"),
                  "cannot be the inout parameter 'x' of 'f'"},
        ErrorCase{"ImplicitLevel", "PG048", body("sampler2D s; RWTexture2D<float4> i;", "i[id.xy] = @tex2D(s, id.xy);"),
                  "; write tex2Dlod"},
        ErrorCase{"Bias", "PG048", body("sampler3D s;", "float4 v = @tex3Dbias(s, 0);"), "; write tex3Dlod"},
        ErrorCase{"Derivative", "PG048", body("", "float v = @ddx(id.x);"), "'ddx' is for pixel shaders"},
        ErrorCase{"Clip", "PG048", body("", "@clip(-1);"), "'clip' is for pixel shaders"},
        ErrorCase{"Discard", "PG048", body("", "if (id.x) @discard;"), "'discard' is for pixel shaders"},
        ErrorCase{"InAFunction", "PG048", "float f(float x) { return @fwidth(x); }\n" + body("", "float v = f(1);"),
                  "'fwidth' is for pixel shaders"},
        ErrorCase{"Barrier", "PG048", pixel("", "@GroupMemoryBarrierWithGroupSync();"), "is for compute shaders"},
        ErrorCase{"Shared", "PG048", pixel("groupshared float f;", "float g = @f;"), "groupshared variable 'f'"},
        ErrorCase{"Image", "PG048", pixel("RWTexture2D<float> i;", "@i[uint2(0, 0)] = 1;"), "RWTexture2D 'i'"}),
    [](const auto& error) { return std::string(error.param.name); });

}  // namespace
}  // namespace permgen

// The float forms of raycast.fx, one value for each pixel: its inputs are a texel of Inputs.
#include "../../shaders/integrals.fxh"
#include "../../shaders/precise.fxh"
#include "../../shaders/scattering.fxh"

float4 gWidth;  // x: texels of Inputs in a row

sampler2D InputSampler = sampler_state
{
    MinFilter = POINT; MagFilter = POINT; MipFilter = NONE;
    AddressU = CLAMP; AddressV = CLAMP;
};

float4 vs_main(float2 position : POSITION0) : POSITION0
{
    return float4(position, 0.5, 1.0);
}

float4 input_at(float2 pixel)
{
    return tex2Dlod(InputSampler, float4((pixel.x + 0.5) / gWidth.x, 0.5, 0.0, 0.0));
}

float4 ps_arc(float2 pixel : VPOS) : COLOR0
{
    float4 v = input_at(pixel);
    return arc_over_side(v.x, v.y).xxxx;
}

float4 ps_products(float2 pixel : VPOS) : COLOR0
{
    float4 v = input_at(pixel);
    return difference_of_products(v.x, v.y, v.z, v.w).xxxx;
}

// x: cos of the angle, y: its sine, z: g.
float4 ps_phase(float2 pixel : VPOS) : COLOR0
{
    float4 v = input_at(pixel);
    return phase(float3(0.0, 0.0, 1.0), float3(v.y, 0.0, v.x), v.z, v.w).xxxx;
}

technique arc      { pass p0 { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_arc(); } }
technique products { pass p0 { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_products(); } }
technique phases   { pass p0 { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_phase(); } }

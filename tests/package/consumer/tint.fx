// An effect unrelated to light shafts.
#include "tint.fxh"

sampler2D PictureSampler;

struct Corner
{
    float4 position : POSITION;
    float2 uv       : TEXCOORD0;
};

Corner vs_main(float4 position : POSITION, float2 uv : TEXCOORD0)
{
    Corner corner;
    corner.position = position;
    corner.uv = uv;
    return corner;
}

float4 ps_main(float2 uv : TEXCOORD0, uniform bool bPicture, uniform float fStrength) : COLOR0
{
    float4 colour = gTint * fStrength;
    if (bPicture)
        colour *= tex2D(PictureSampler, uv);
    return colour;
}

technique plain { pass { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_main(false, 0.5); } }
technique picture { pass { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_main(true, 1.0); } }

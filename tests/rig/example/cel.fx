// A hand-drawn look: flat bands of paint, then pencil strokes where it is dark. It is not about light shafts; it shows
// that permgen-rig works with any effect.

float4x4 gClipFromWorld;
float4x4 gWorldFromBody;
float3   gTowardsLight;   // of unit length
float3   gEye;            // world space
float4   gPaint;
int      gStrokes;        // across the body

sampler2D PaperSampler = sampler_state
{
    MinFilter = LINEAR; MagFilter = LINEAR; MipFilter = NONE;
    AddressU = WRAP; AddressV = WRAP;
};
sampler2D PencilSampler = sampler_state
{
    MinFilter = LINEAR; MagFilter = LINEAR; MipFilter = NONE;
    AddressU = WRAP; AddressV = WRAP;
};

struct Corner
{
    float4 position : POSITION;
    float3 normal   : NORMAL;
    float2 uv       : TEXCOORD0;
};

struct Surface
{
    float4 position : POSITION;
    float3 normal   : TEXCOORD0;
    float3 world    : TEXCOORD1;
    float2 uv       : TEXCOORD2;
};

Surface vs_body(Corner corner)
{
    Surface surface;
    float4 world = mul(gWorldFromBody, corner.position);
    surface.position = mul(gClipFromWorld, world);
    surface.normal = mul((float3x3)gWorldFromBody, corner.normal);
    surface.world = world.xyz;
    surface.uv = corner.uv;
    return surface;
}

// The given number of flat bands; with 0 the light stays smooth. A gloss above 0 is the smallest cosine of the white
// highlight.
float4 ps_paint(float3 normal : TEXCOORD0, float3 world : TEXCOORD1, float2 uv : TEXCOORD2,
                uniform int nBands, uniform float fGloss, uniform bool bPaper) : COLOR0
{
    float3 n = normalize(normal);
    float light = saturate(dot(n, gTowardsLight));
    if (nBands > 0)
        light = floor(light * nBands + 0.5) / nBands;
    float3 colour = gPaint.rgb * (0.25 + 0.75 * light);
    if (fGloss > 0.0)
    {
        float3 halfway = normalize(gTowardsLight + normalize(gEye - world));
        colour += step(fGloss, dot(n, halfway)) * 0.6;
    }
    if (bPaper)
        colour *= 0.7 + 0.3 * tex2D(PaperSampler, uv * 3.0).rgb;
    return float4(colour, 1.0);
}

// Multiplied with the paint: white changes nothing.
float4 ps_pencil(float3 normal : TEXCOORD0, float2 uv : TEXCOORD2,
                 uniform float fPressure, uniform bool bCrossed) : COLOR0
{
    float dark = 1.0 - saturate(dot(normalize(normal), gTowardsLight));
    float2 at = float2(uv.x + 0.5 * uv.y, uv.y) * gStrokes;
    float stroke = tex2D(PencilSampler, at).r;
    if (bCrossed)
        stroke = max(stroke, tex2D(PencilSampler, float2(uv.x - 0.5 * uv.y, uv.y) * gStrokes).r);
    float left = 1.0 - fPressure * dark * stroke;
    return float4(left, left, left, 1.0);
}

#define PAINT(bands, gloss, paper) \
    pass paint { \
        VertexShader = compile vs_3_0 vs_body(); \
        PixelShader = compile ps_3_0 ps_paint(bands, gloss, paper); \
        ZEnable = TRUE; ZWriteEnable = TRUE; ZFunc = LESSEQUAL; CullMode = CCW; }

#define PENCIL(pressure, crossed) \
    pass pencil { \
        VertexShader = compile vs_3_0 vs_body(); \
        PixelShader = compile ps_3_0 ps_pencil(pressure, crossed); \
        ZEnable = TRUE; ZWriteEnable = FALSE; ZFunc = LESSEQUAL; CullMode = CCW; \
        AlphaBlendEnable = TRUE; SrcBlend = ZERO; DestBlend = SRCCOLOR; }

technique smooth           { PAINT(0, 0.0, false) }
technique three_bands      { PAINT(3, 0.96, false) }
technique five_bands_paper { PAINT(5, 0.0, true) }
technique drawing          { PAINT(3, 0.96, true) PENCIL(0.6, false) }
technique drawing_crossed  { PAINT(4, 0.0, false) PENCIL(0.9, true) }

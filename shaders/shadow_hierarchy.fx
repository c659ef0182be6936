// The shadow hierarchy of a shadow map: for blocks of its cells, the smallest and the largest stored depth.
//
// Cell (i, j) lies between the centres of the texels i, i + 1 and j, j + 1. Level n holds blocks of 2^(n+1) cells a
// side, in an image of half the map's size rounded up to a power of two, with all mip levels. A ray whose depth is
// outside of a block's range is lit, or dark, in all of the block; see raycast.fx.

float4 gLevel;  // x: size of the level that is drawn, in blocks a side, y: size of the source, in texels a side

sampler2D SourceSampler = sampler_state
{
    MinFilter = POINT; MagFilter = POINT; MipFilter = NONE;
    AddressU = CLAMP; AddressV = CLAMP;
};

struct Corner
{
    float4 position : POSITION0;
    float4 tc       : TEXCOORD0;
};

Corner vs_main(float2 position : POSITION0)
{
    Corner o;
    o.position = float4(position, 0.0, 1.0);
    o.tc = float4(0.5 * position + 0.5, 0.0, 1.0);
    return o;
}

// The source is the shadow map, or the level below.
float4 ps_main(float4 tc : TEXCOORD0, uniform bool bFromMap) : COLOR0
{
    float2 block = floor(tc.xy * gLevel.x);
    float2 bounds = float2(1.0, 0.0);
    // Blocks of two cells share their border's texels: three a side.
    int texels = bFromMap ? 3 : 2;
    for (int j = 0; j < texels; ++j)
        for (int i = 0; i < texels; ++i)
        {
            float2 uv = (2.0 * block + float2(i, j) + 0.5) / gLevel.y;
            float4 stored = tex2Dlod(SourceSampler, float4(uv, 0.0, 0.0));
            bounds = float2(min(bounds.x, stored.r), max(bounds.y, bFromMap ? stored.r : stored.g));
        }
    return float4(bounds, 0.0, 1.0);
}

#define HIERARCHY_TECHNIQUE(name, fromMap) \
    technique name { pass p0 { \
        VertexShader = compile vs_3_0 vs_main(); \
        PixelShader = compile ps_3_0 ps_main(fromMap); \
        ZEnable = FALSE; ZWriteEnable = FALSE; CullMode = NONE; } }

HIERARCHY_TECHNIQUE(hierarchy_from_map_technique, true)
HIERARCHY_TECHNIQUE(hierarchy_from_level_technique, false)

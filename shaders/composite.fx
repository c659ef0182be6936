// Adds a group's accumulated shafts to the picture. One triangle covers the target; the blend states
// add, so the scene's picture stays.

float4 gTint;   // rgb: the group's tint, divided by the accumulation target's value for a radiance of 1
float4 gTexel;  // xy: one texel of the targets in texture coordinates
float4 gDepth;  // reversed depth = x + y * stored depth

sampler2D AccumulationSampler = sampler_state
{
    MinFilter = POINT; MagFilter = POINT; MipFilter = NONE;
    AddressU = CLAMP; AddressV = CLAMP;
};
sampler2D SceneDepthSampler = sampler_state
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

// Slice i went into channel i mod 4 of a routed target: the sum of the channels is the sum of the slices.
float3 shafts(float2 uv, bool routed)
{
    float4 texel = tex2Dlod(AccumulationSampler, float4(uv, 0.0, 0.0));
    float sum = texel.r + texel.g + texel.b + texel.a;
    return routed ? float3(sum, sum, sum) : texel.rgb;
}

float reversed_depth(float2 uv)
{
    return gDepth.x + gDepth.y * tex2Dlod(SceneDepthSampler, float4(uv, 0.0, 0.0)).r;
}

// One weighted texel: rgb times weight, weight.
//
// Reversed depth with the far plane at infinity is near / d, so |a - b| / max(a, b) is |da - db| / max(da, db):
// the distance between two surfaces relative to their depth, without linearization. A finite far plane
// subtracts a constant from both, which only makes the measure larger: less blur, but no halo. The
// background, 0, differs by 1 from every surface and by 0 from itself.
//
// Blur across an edge below the tolerance is bounded: two rays whose depths differ by a tenth share nine
// tenths of their air.
float4 tap(float2 uv, float depth, float weight, bool routed)
{
    float other = reversed_depth(uv);
    float difference = abs(other - depth) / max(max(other, depth), 1e-30);
    float w = weight * saturate(1.0 - 10.0 * difference);
    return float4(shafts(uv, routed) * w, w);
}

float4 ps_main(float4 tc : TEXCOORD0, uniform bool bRouted, uniform bool bBlur) : COLOR0
{
    float3 sum;
    if (bBlur)
    {
        // Binomial 3 x 3: removes the alternation of neighbouring slices, keeps the edges of the shafts.
        float2 uv = tc.xy;
        float2 right = float2(gTexel.x, 0.0);
        float2 down = float2(0.0, gTexel.y);
        float depth = reversed_depth(uv);
        float4 taps = tap(uv, depth, 4.0, bRouted);
        taps += tap(uv - right, depth, 2.0, bRouted) + tap(uv + right, depth, 2.0, bRouted);
        taps += tap(uv - down, depth, 2.0, bRouted) + tap(uv + down, depth, 2.0, bRouted);
        taps += tap(uv - right - down, depth, 1.0, bRouted) + tap(uv + right - down, depth, 1.0, bRouted);
        taps += tap(uv - right + down, depth, 1.0, bRouted) + tap(uv + right + down, depth, 1.0, bRouted);
        sum = taps.rgb / taps.a;
    }
    else
    {
        sum = shafts(tc.xy, bRouted);
    }
    return float4(sum * gTint.rgb, 0.0);
}

#define COMPOSITE_TECHNIQUE(name, routed, blur) \
    technique name { pass p0 { \
        VertexShader = compile vs_3_0 vs_main(); \
        PixelShader = compile ps_3_0 ps_main(routed, blur); \
        AlphaBlendEnable = TRUE; SrcBlend = ONE; DestBlend = ONE; BlendOp = ADD; \
        ZEnable = FALSE; ZWriteEnable = FALSE; CullMode = NONE; } }

COMPOSITE_TECHNIQUE(plain_noblur_technique,  false, false)
COMPOSITE_TECHNIQUE(plain_blur_technique,    false, true)
COMPOSITE_TECHNIQUE(routed_noblur_technique, true,  false)
COMPOSITE_TECHNIQUE(routed_blur_technique,   true,  true)

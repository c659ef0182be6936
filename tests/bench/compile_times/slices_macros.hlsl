// The slice shader written without permgen: Vulkan's HLSL with a macro for each switch, compiled once for each
// technique. Same terms and the same interface as shaders/slices.fx, so that compile_times compares equivalent shaders.

#ifndef NOISE
#define NOISE 0
#endif
#ifndef SHADOW
#define SHADOW 0
#endif
#ifndef COOKIE
#define COOKIE 0
#endif
#ifndef SCATTERING
#define SCATTERING 0
#endif

[[vk::binding(0, 0)]] cbuffer Globals
{
    float4x4 gClipFromView;
    float4x4 gLightFromView;
    float4   gBoundsMin;
    float4   gBoundsMax;
    float4   gClipPlanes[8];
    float4   gCookieScale;
    float4   gAttenuation;
    float4   gDust;
    float4   gNoise1;
    float4   gNoise2;
    float4   gColour;
    float4   gWeight;
    float4   gShadow;
    float4   gScattering;
    float4   gEye;
};
[[vk::binding(1, 0)]] Texture2D CookieTexture;
[[vk::binding(1, 0)]] SamplerState CookieSampler;
[[vk::binding(2, 0)]] Texture2D NoiseTexture;
[[vk::binding(2, 0)]] SamplerState NoiseSampler;
[[vk::binding(3, 0)]] Texture2D ShadowTexture;
[[vk::binding(3, 0)]] SamplerState ShadowSampler;

struct SliceVertex
{
    [[vk::location(0)]] float3 position    : POSITION;
    [[vk::location(1)]] float  thickness   : TEXCOORD0;
    [[vk::location(2)]] float4 channelMask : COLOR0;
};

struct SlicePoint
{
    [[vk::location(0)]] float4 tcProj        : TEXCOORD0;
    [[vk::location(1)]] float4 tcProjScroll1 : TEXCOORD1;
    [[vk::location(2)]] float4 tcProjScroll2 : TEXCOORD2;
    [[vk::location(3)]] float4 lsPos_depth   : TEXCOORD3;
    [[vk::location(4)]] float4 slab          : TEXCOORD4;
    [[vk::location(5)]] float4 channelMask   : COLOR0;
};

struct ClippedSlicePoint
{
    float4 position : SV_Position;
    SlicePoint point_;
    float4 clip0 : SV_ClipDistance0;
    float4 clip1 : SV_ClipDistance1;
};

ClippedSlicePoint vs_main(SliceVertex v)
{
    ClippedSlicePoint o;
    float3 extent = gBoundsMax.xyz - gBoundsMin.xyz;
    float4 viewPos = float4(gBoundsMin.xyz + extent * v.position, 1.0);
    float4 lsPos = mul(gLightFromView, viewPos);
    float axis = -lsPos.z;
    float2 uv = lsPos.xy * float2(gCookieScale.x, -gCookieScale.y) + 0.5 * axis;
    o.position = mul(gClipFromView, viewPos);
    o.point_.tcProj = float4(uv, 0.0, axis);
    o.point_.tcProjScroll1 = float4(uv * gNoise1.xy + gNoise1.zw * axis, 0.0, axis);
    o.point_.tcProjScroll2 = float4(uv * gNoise2.xy + gNoise2.zw * axis, 0.0, axis);
    o.point_.lsPos_depth = float4(lsPos.xyz, axis);
    o.point_.slab = float4(viewPos.xyz / -viewPos.z, abs(extent.z) * v.thickness);
    o.point_.channelMask = v.channelMask;
    o.clip0 = float4(dot(gClipPlanes[0], viewPos), dot(gClipPlanes[1], viewPos),
                     dot(gClipPlanes[2], viewPos), dot(gClipPlanes[3], viewPos));
    o.clip1 = float4(dot(gClipPlanes[4], viewPos), dot(gClipPlanes[5], viewPos),
                     dot(gClipPlanes[6], viewPos), dot(gClipPlanes[7], viewPos));
    return o;
}

#if SHADOW
float light_through(float2 uv, float depth)
{
    float size = gShadow.z;
    float2 texel = uv * size - 0.5;
    float2 corner = floor(texel);
    float2 part = texel - corner;
    float2 uv00 = (corner + 0.5) / size;
    float2 uv11 = (corner + 1.5) / size;
    float s00 = ShadowTexture.SampleLevel(ShadowSampler, uv00, 0.0).r;
    float s10 = ShadowTexture.SampleLevel(ShadowSampler, float2(uv11.x, uv00.y), 0.0).r;
    float s01 = ShadowTexture.SampleLevel(ShadowSampler, float2(uv00.x, uv11.y), 0.0).r;
    float s11 = ShadowTexture.SampleLevel(ShadowSampler, uv11, 0.0).r;
    float4 lit = step(float4(s00, s10, s01, s11), float4(depth, depth, depth, depth));
    float2 rows = lerp(lit.xz, lit.yw, part.x);
    return lerp(rows.x, rows.y, part.y);
}
#endif

#if SCATTERING
float3 unit(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
}

float scattering(float3 position)
{
    bool parallel = gScattering.w > 0.0;
    float3 toEye = parallel ? gEye.xyz : gEye.xyz - position;
    float eyeDistance = parallel ? gEye.w - dot(gEye.xyz, position) : length(toEye);
    float away = gScattering.x < 0.0 ? -1.0 : 1.0;
    float strength = abs(gScattering.x);
    float3 chord = unit(position) - away * unit(toEye);
    float base = gScattering.z * gScattering.z + strength * dot(chord, chord);
    float phase = gScattering.z / base * ((1.0 + strength) / sqrt(base));
    return phase * exp(-gScattering.y * (length(position) + eyeDistance));
}
#endif

float4 ps_main(SlicePoint p) : SV_Target0
{
#if NOISE
    float noise1 = NoiseTexture.SampleLevel(NoiseSampler, p.tcProjScroll1.xy / p.tcProjScroll1.w, 0.0).r;
    float noise2 = NoiseTexture.SampleLevel(NoiseSampler, p.tcProjScroll2.xy / p.tcProjScroll2.w, 0.0).g;
    float compositeNoise = gDust.y * noise1 * noise2;
#else
    float compositeNoise = gDust.x;
#endif
#if COOKIE
    float3 cookie = CookieTexture.SampleLevel(CookieSampler, p.tcProj.xy / p.tcProj.w, 0.0).rgb;
#else
    float3 cookie = float3(1.0, 1.0, 1.0);
#endif
    float shadow = 1.0;
#if SHADOW
    float depth = clamp(gShadow.x + gShadow.y / (p.lsPos_depth.w - gShadow.w), 0.0, 0.99999994);
    shadow = light_through(p.tcProj.xy / p.tcProj.w, depth);
#endif
    float mask = p.lsPos_depth.w > 0.0 ? shadow * compositeNoise : 0.0;
    float3 d = p.lsPos_depth.xyz * gAttenuation.z;
    float atten = gAttenuation.x / dot(d, d) + gAttenuation.y;
    float scattered = 1.0;
#if SCATTERING
    scattered = scattering(p.lsPos_depth.xyz);
#endif
    float thickness = gWeight.y > 0.0 ? p.slab.w : 1.0;
    float slant = gWeight.z > 0.0 ? length(p.slab.xyz) : 1.0;
    float intensity = mask * atten * scattered * (gWeight.x * thickness * slant);
    float3 colour = gColour.rgb * cookie * intensity;
    float grey = dot(colour, float3(0.2126, 0.7152, 0.0722));
    return p.channelMask * float4(gColour.w > 0.0 ? float3(grey, grey, grey) : colour, grey);
}

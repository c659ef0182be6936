// Lit surfaces in the dusty air that slices.fx fills with light. A base pass lays down depth, a little
// ambient light and emission; one more pass for each projector adds its light, with the same cookie, the same
// shadow map and the same I / d^2, so that a shaft and the pool at its end agree:
//
//   L = albedo / pi * cookie * shadow * (I / d^2 + ambient) * max(cos, 0)
//
// Spaces and matrices as in slices.fx: view space has the eye at the origin, light space the lamp; both
// are in metres and look along -Z.

#include "shadow.fxh"

float4x4 gClipFromMesh;
float4x4 gViewFromMesh;
float4x4 gViewFromNormal;  // the cofactors of gViewFromMesh's upper 3x3: right for a flattened mesh, too
float4x4 gLightFromView;   // rigid
float4   gEye;             // direction to the eye is xyz - w * position: (0, 0, 0, 1), or (0, 0, 1, 0) for parallel rays
float4   gAlbedo;          // rgb: base colour
float4   gEmission;        // rgb: radiance
float4   gAmbient;         // rgb: radiance that a white surface reflects where it faces the sky
float4   gUp;              // xyz: the sky's direction in view space, w: share of gAmbient from below, 0 to 1
float4   gIntensity;       // rgb: light colour * candela, w: ambient of the light in cd/m^2 over candela
float4   gRange;           // x: near, y: far, metres along the light's axis
float4   gCookieScale;     // xy: 0.5 / tan(fov / 2), horizontal and vertical
float4   gShadow;          // stored depth = x + y / axis; z: map size in texels
float4   gTexel;           // xy: a shadow map texel at one metre of axis, in metres
float4   gWalls[4];        // view space, keeps dot(n, p) + d >= 0: the light ends at these; unused ones are
                           // (0, 0, 0, 1)

sampler2D BaseColourSampler = sampler_state
{
    MinFilter = LINEAR; MagFilter = LINEAR; MipFilter = NONE;
    AddressU = WRAP; AddressV = WRAP;
};
sampler2D CookieSampler = sampler_state
{
    MinFilter = LINEAR; MagFilter = LINEAR; MipFilter = NONE;
    AddressU = CLAMP; AddressV = CLAMP;
};
sampler2D ShadowMapSampler = sampler_state  // reversed depth: 1 at the light's near plane, 0 at its far plane
{
    MinFilter = POINT; MagFilter = POINT; MipFilter = NONE;
    AddressU = CLAMP; AddressV = CLAMP;
};

struct MeshVertex
{
    float3 position : POSITION0;
    float3 normal   : NORMAL0;
    float2 uv       : TEXCOORD0;
};

struct SurfacePoint
{
    float4 position : POSITION0;
    float4 viewPos  : TEXCOORD0;
    float4 normal   : TEXCOORD1;  // view space, not unit length
    float4 uv       : TEXCOORD2;
};

SurfacePoint vs_surface(MeshVertex v)
{
    SurfacePoint o;
    float4 meshPos = float4(v.position, 1.0);
    o.position = mul(gClipFromMesh, meshPos);
    o.viewPos = mul(gViewFromMesh, meshPos);
    o.normal = float4(mul(gViewFromNormal, float4(v.normal, 0.0)).xyz, 0.0);
    o.uv = float4(v.uv, 0.0, 0.0);
    return o;
}

// Keeps a zero vector; normalize() would make it NaN.
float3 unit(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1.0e-30));
}

// The normal of the triangle's side that the eye sees, for either winding.
float3 facing_normal(float3 viewPos)
{
    float3 face = unit(cross(ddx(viewPos), ddy(viewPos)));
    return dot(face, gEye.xyz - gEye.w * viewPos) < 0.0 ? -face : face;
}

float3 shading_normal(float3 interpolated, float3 facing)
{
    float3 normal = dot(interpolated, interpolated) > 0.0 ? unit(interpolated) : facing;
    return dot(normal, facing) < 0.0 ? -normal : normal;
}

float3 albedo_at(float2 uv, bool textured)
{
    float3 albedo = gAlbedo.rgb;
    if (textured)
        albedo *= tex2D(BaseColourSampler, uv).rgb;
    return albedo;
}

float4 ps_base(float4 viewPos : TEXCOORD0,
               float4 normal  : TEXCOORD1,
               float4 uv      : TEXCOORD2,
               uniform bool bTexture) : COLOR0
{
    float3 n = shading_normal(normal.xyz, facing_normal(viewPos.xyz));
    float sky = lerp(gUp.w, 1.0, 0.5 + 0.5 * dot(n, gUp.xyz));
    return float4(albedo_at(uv.xy, bTexture) * gAmbient.rgb * sky + gEmission.rgb, 1.0);
}

float4 ps_light(float4 viewPos : TEXCOORD0,
                float4 normal  : TEXCOORD1,
                float4 uv      : TEXCOORD2,
                uniform bool bShadowMapping,
                uniform bool bCookie,
                uniform bool bTexture) : COLOR0
{
    float3 facing = facing_normal(viewPos.xyz);
    float3 n = mul(gLightFromView, float4(shading_normal(normal.xyz, facing), 0.0)).xyz;
    float3 face = mul(gLightFromView, float4(facing, 0.0)).xyz;
    float3 lsPos = mul(gLightFromView, float4(viewPos.xyz, 1.0)).xyz;
    float axis = -lsPos.z;
    float2 slide = lsPos.xy * float2(gCookieScale.x, -gCookieScale.y) / axis + 0.5;

    float3 light = gIntensity.rgb;
    if (bCookie)
        light *= tex2Dlod(CookieSampler, float4(slide, 0.0, 0.0)).rgb;

    if (bShadowMapping)
    {
        // The four texels that are read lie up to one texel to each side, where this plane's depth differs by
        // its slope. Lifting the point off its surface by that much keeps the surface from shading itself.
        float lift = axis * (1.1 * dot(abs(face.xy), gTexel.xy) + 1.0e-4);
        float3 lifted = lsPos + face * lift;
        float liftedAxis = -lifted.z;
        float2 place = lifted.xy * float2(gCookieScale.x, -gCookieScale.y) / liftedAxis + 0.5;
        light *= light_through(ShadowMapSampler, gShadow.z, place,
                               clamp(gShadow.x + gShadow.y / liftedAxis, 0.0, 0.99999994));
    }

    float2 inside = step(float2(0.0, 0.0), slide) * step(slide, float2(1.0, 1.0));
    float4 place = float4(viewPos.xyz, 1.0);
    float4 walls = float4(dot(gWalls[0], place), dot(gWalls[1], place), dot(gWalls[2], place), dot(gWalls[3], place));
    bool reached = axis >= gRange.x && axis <= gRange.y && inside.x * inside.y > 0.0 && all(walls >= 0.0);
    float d2 = max(dot(lsPos, lsPos), 1.0e-12);
    float cosine = max(dot(n, -lsPos) * rsqrt(d2), 0.0);
    float3 irradiance = light * (1.0 / d2 + gIntensity.w) * cosine;
    float3 radiance = albedo_at(uv.xy, bTexture) * irradiance * 0.318309886;  // 1 / pi
    return float4(reached ? radiance : float3(0.0, 0.0, 0.0), 0.0);
}

#define BASE_TECHNIQUE(name, textured) \
    technique name { pass p0 { \
        VertexShader = compile vs_3_0 vs_surface(); \
        PixelShader = compile ps_3_0 ps_base(textured); \
        AlphaBlendEnable = FALSE; ZEnable = TRUE; ZWriteEnable = TRUE; ZFunc = GREATEREQUAL; } }

// Adds to the base pass, at its depth.
#define LIGHT_TECHNIQUE(name, shadow, cookie, textured) \
    technique name { pass p0 { \
        VertexShader = compile vs_3_0 vs_surface(); \
        PixelShader = compile ps_3_0 ps_light(shadow, cookie, textured); \
        AlphaBlendEnable = TRUE; SrcBlend = ONE; DestBlend = ONE; BlendOp = ADD; \
        ZEnable = TRUE; ZWriteEnable = FALSE; ZFunc = GREATEREQUAL; } }

BASE_TECHNIQUE(base_texture_technique,   true)
BASE_TECHNIQUE(base_notexture_technique, false)

LIGHT_TECHNIQUE(light_shadow_cookie_texture_technique,       true,  true,  true)
LIGHT_TECHNIQUE(light_shadow_cookie_notexture_technique,     true,  true,  false)
LIGHT_TECHNIQUE(light_shadow_nocookie_texture_technique,     true,  false, true)
LIGHT_TECHNIQUE(light_shadow_nocookie_notexture_technique,   true,  false, false)
LIGHT_TECHNIQUE(light_noshadow_cookie_texture_technique,     false, true,  true)
LIGHT_TECHNIQUE(light_noshadow_cookie_notexture_technique,   false, true,  false)
LIGHT_TECHNIQUE(light_noshadow_nocookie_texture_technique,   false, false, true)
LIGHT_TECHNIQUE(light_noshadow_nocookie_notexture_technique, false, false, false)

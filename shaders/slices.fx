// Volumetric light shafts by slices: Jason L. Mitchell, "Light Shafts: Rendering Shadows in
// Participating Media" (GDC 2004; ShaderX3, 2004). A light's volume is cut by planes perpendicular to
// the view direction; every plane is drawn once, adding the light that its slab of air scatters
// towards the eye:
//
//   L = density / (4 pi) * integral over the ray of
//       noise * cookie * shadow * phase * transmittance * (I / d^2 + ambient) dt
//
// with phase and transmittance 1 unless a technique scatters; see scattering().
//
// Spaces: *view* has the eye at the origin and looks along -Z; *light* has the lamp at the origin and
// looks along -Z with +Y up. Both are in metres. Matrices multiply column vectors: mul(matrix, vector).

#include "shadow.fxh"

float4x4 gClipFromView;
float4x4 gLightFromView;   // rigid; the last row is (0, 0, 0, 1)
float4   gBoundsMin;       // xyz: view-space corner that a vertex coordinate of 0 stands for
float4   gBoundsMax;       // xyz: view-space corner that a vertex coordinate of 1 stands for
float4   gClipPlanes[8];   // view space, keeps dot(n, p) + d >= 0; unused ones are (0, 0, 0, 1)
float4   gCookieScale;     // xy: 0.5 / tan(fov / 2), horizontal and vertical
float4   gAttenuation;     // x: I in candela, y: ambient in cd/m^2, z: light units per metre
float4   gDust;            // x: factor without noise, y: gain of the noise product
float4   gNoise1;          // xy: repeats over the field of view, zw: phase in [0, 1)
float4   gNoise2;
float4   gColour;          // rgb: light colour * density / (4 pi) * target scale, w: 1 = one grey value
float4   gWeight;          // x: factor, y: exponent of the slab's thickness, z: of the ray's slant (1 or 0 each)
float4   gShadow;          // stored depth = x + y / w; z: map size in texels, w: bias in metres
float4   gScattering;      // x: anisotropy g, y: extinction in 1/m, z: 1 - |g|, w: 1 = view rays are parallel
float4   gEye;             // light space; xyz: the eye; for parallel rays the unit direction to it, and w is
                           // the lamp's view depth in metres

sampler2D CookieSampler = sampler_state
{
    MinFilter = LINEAR; MagFilter = LINEAR; MipFilter = NONE;
    AddressU = CLAMP; AddressV = CLAMP;
};
sampler2D ScrollingNoiseSampler = sampler_state
{
    MinFilter = LINEAR; MagFilter = LINEAR; MipFilter = NONE;
    AddressU = WRAP; AddressV = WRAP;
};
sampler2D ShadowMapSampler = sampler_state  // reversed depth: 1 at the light's near plane, 0 at its far plane
{
    MinFilter = POINT; MagFilter = POINT; MipFilter = NONE;
    AddressU = CLAMP; AddressV = CLAMP;
};

struct SliceVertex
{
    float3 position    : POSITION0;  // view space for exact polygons, unit cube for stretched quads
    float  thickness   : TEXCOORD0;  // of the slab this slice stands for, in units of gBoundsMax.z - gBoundsMin.z
    float4 channelMask : COLOR0;
};

struct SlicePoint
{
    float4 position      : POSITION0;
    float4 tcProj        : TEXCOORD0;  // cookie and shadow map
    float4 tcProjScroll1 : TEXCOORD1;
    float4 tcProjScroll2 : TEXCOORD2;
    float4 lsPos_depth   : TEXCOORD3;  // xyz: light space, w: distance along the light's axis
    float4 slab          : TEXCOORD4;  // xyz: view ray for one metre of depth, w: slab thickness in metres
    float4 ChannelMask   : COLOR0;
    float4 clip0         : SV_ClipDistance0;
    float4 clip1         : SV_ClipDistance1;
};

// One vertex shader serves both geometries. Exact polygons come in view space with bounds (0, 0, 0) and
// (1, 1, 1) and clip planes that keep everything; the published unit-cube quads are stretched over the
// light volume's bounds here and cut by the clip planes.
SlicePoint vs_main(SliceVertex v)
{
    SlicePoint o;
    float3 extent = gBoundsMax.xyz - gBoundsMin.xyz;
    float4 viewPos = float4(gBoundsMin.xyz + extent * v.position, 1.0);
    float4 lsPos = mul(gLightFromView, viewPos);
    float axis = -lsPos.z;

    // (0, 0) is the cookie's top left corner: light-space -X and +Y.
    float2 uv = lsPos.xy * float2(gCookieScale.x, -gCookieScale.y) + 0.5 * axis;

    o.position = mul(gClipFromView, viewPos);
    o.tcProj = float4(uv, 0.0, axis);
    o.tcProjScroll1 = float4(uv * gNoise1.xy + gNoise1.zw * axis, 0.0, axis);
    o.tcProjScroll2 = float4(uv * gNoise2.xy + gNoise2.zw * axis, 0.0, axis);
    o.lsPos_depth = float4(lsPos.xyz, axis);
    o.slab = float4(viewPos.xyz / -viewPos.z, abs(extent.z) * v.thickness);
    o.ChannelMask = v.channelMask;
    o.clip0 = float4(dot(gClipPlanes[0], viewPos), dot(gClipPlanes[1], viewPos),
                     dot(gClipPlanes[2], viewPos), dot(gClipPlanes[3], viewPos));
    o.clip1 = float4(dot(gClipPlanes[4], viewPos), dot(gClipPlanes[5], viewPos),
                     dot(gClipPlanes[6], viewPos), dot(gClipPlanes[7], viewPos));
    return o;
}

// Projective lookup at an explicit level: derivatives are invalid at a slice's edge and where w changes sign.
float4 project(sampler2D map, float4 tc)
{
    return tex2Dlod(map, float4(tc.xy / tc.w, 0.0, 0.0));
}

// The unit vector; 0 for a vector too short to have a direction.
float3 unit(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
}

// Light that a particle at `position` (light space) sends to the eye, relative to one that scatters evenly in
// clear air: phase * transmittance. Applies to `ambient` as well, which is light of the lamp.
//
// The phase function is that of Henyey and Greenstein (Astrophysical Journal 93, 1941) times 4 pi: 1 for g =
// 0. With g > 0 air is brightest in the direction of the lamp.
//
//   phase = (1 - g^2) / (1 + g^2 - 2 g cos)^(3/2),  cos = dot(lamp to particle, particle to eye)
//   transmittance = exp(-extinction * (distance lamp to particle + distance particle to eye))
//
// Extinction is that of evenly filled air: noise does not change it. Otherwise each slice would need its own
// integral along both paths.
float scattering(float3 position)
{
    bool parallel = gScattering.w > 0.0;
    float3 toEye = parallel ? gEye.xyz : gEye.xyz - position;
    float eyeDistance = parallel ? gEye.w - dot(gEye.xyz, position) : length(toEye);

    // 1 + g^2 - 2 g cos = (1 - |g|)^2 + |g| |a -+ b|^2 with the unit vectors a and b: no term cancels where |g| and
    // cos are near 1.
    float away = gScattering.x < 0.0 ? -1.0 : 1.0;
    float strength = abs(gScattering.x);
    float3 chord = unit(position) - away * unit(toEye);
    float base = gScattering.z * gScattering.z + strength * dot(chord, chord);
    float phase = gScattering.z / base * ((1.0 + strength) / sqrt(base));

    return phase * exp(-gScattering.y * (length(position) + eyeDistance));
}

// The slice shader: the light that one slab of air adds to one pixel.
float4 ps_main(float4 tcProj        : TEXCOORD0,
               float4 tcProjScroll1 : TEXCOORD1,
               float4 tcProjScroll2 : TEXCOORD2,
               float4 lsPos_depth   : TEXCOORD3,
               float4 slab          : TEXCOORD4,
               float4 ChannelMask   : COLOR0,
               uniform bool bScrollingNoise,
               uniform bool bShadowMapping,
               uniform bool bCookie,
               uniform bool bScattering) : COLOR0
{
    float compositeNoise = gDust.x;
    if (bScrollingNoise)
    {
        // One texture carries both maps; they drift over each other.
        float noise1 = project(ScrollingNoiseSampler, tcProjScroll1).r;
        float noise2 = project(ScrollingNoiseSampler, tcProjScroll2).g;
        compositeNoise = gDust.y * noise1 * noise2;
    }

    float3 cookie = float3(1.0, 1.0, 1.0);
    if (bCookie)
        cookie = project(CookieSampler, tcProj).rgb;

    float shadow = 1.0;
    if (bShadowMapping)
    {
        // Clamped just under 1: a map filled with 1 blocks everything. Clamped to 0: an empty map (all 0)
        // blocks nothing.
        float depth = clamp(gShadow.x + gShadow.y / (lsPos_depth.w - gShadow.w), 0.0, 0.99999994);
        shadow = light_through(ShadowMapSampler, gShadow.z, tcProj.xy / tcProj.w, depth);
    }

    // No light behind the lamp: the projection would repeat the beam there, upside down.
    float mask = lsPos_depth.w > 0.0 ? shadow * compositeNoise : 0.0;

    // Inverse square law, per pixel: interpolated from vertices it would be wrong everywhere between them.
    float3 d = lsPos_depth.xyz * gAttenuation.z;
    float atten = gAttenuation.x / dot(d, d) + gAttenuation.y;

    float scattered = 1.0;
    if (bScattering)
        scattered = scattering(lsPos_depth.xyz);

    // A slice represents its slab: the length of this pixel's ray within it.
    float thickness = gWeight.y > 0.0 ? slab.w : 1.0;
    float slant = gWeight.z > 0.0 ? length(slab.xyz) : 1.0;
    float intensity = mask * atten * scattered * (gWeight.x * thickness * slant);

    float3 colour = gColour.rgb * cookie * intensity;
    float grey = dot(colour, float3(0.2126, 0.7152, 0.0722));  // Rec. 709 luminance
    return ChannelMask * float4(gColour.w > 0.0 ? float3(grey, grey, grey) : colour, grey);
}

// Adds to the target, before the scene's surfaces.
#define ADD_SLICES \
    AlphaBlendEnable = TRUE; SrcBlend = ONE; DestBlend = ONE; BlendOp = ADD; \
    ZEnable = TRUE; ZWriteEnable = FALSE; CullMode = NONE;

#define SLICE_TECHNIQUE(name, noise, shadow, cookie, scattering) \
    technique name { pass p0 { \
        VertexShader = compile vs_3_0 vs_main(); \
        PixelShader = compile ps_3_0 ps_main(noise, shadow, cookie, scattering); \
        ADD_SLICES } }

SLICE_TECHNIQUE(clip_noise_shadow_cookie_technique,       true,  true,  true,  false)
SLICE_TECHNIQUE(clip_noise_shadow_nocookie_technique,     true,  true,  false, false)
SLICE_TECHNIQUE(clip_noise_noshadow_cookie_technique,     true,  false, true,  false)
SLICE_TECHNIQUE(clip_noise_noshadow_nocookie_technique,   true,  false, false, false)
SLICE_TECHNIQUE(clip_nonoise_shadow_cookie_technique,     false, true,  true,  false)
SLICE_TECHNIQUE(clip_nonoise_shadow_nocookie_technique,   false, true,  false, false)
SLICE_TECHNIQUE(clip_nonoise_noshadow_cookie_technique,   false, false, true,  false)
SLICE_TECHNIQUE(clip_nonoise_noshadow_nocookie_technique, false, false, false, false)

SLICE_TECHNIQUE(clip_noise_shadow_cookie_scattering_technique,       true,  true,  true,  true)
SLICE_TECHNIQUE(clip_noise_shadow_nocookie_scattering_technique,     true,  true,  false, true)
SLICE_TECHNIQUE(clip_noise_noshadow_cookie_scattering_technique,     true,  false, true,  true)
SLICE_TECHNIQUE(clip_noise_noshadow_nocookie_scattering_technique,   true,  false, false, true)
SLICE_TECHNIQUE(clip_nonoise_shadow_cookie_scattering_technique,     false, true,  true,  true)
SLICE_TECHNIQUE(clip_nonoise_shadow_nocookie_scattering_technique,   false, true,  false, true)
SLICE_TECHNIQUE(clip_nonoise_noshadow_cookie_scattering_technique,   false, false, true,  true)
SLICE_TECHNIQUE(clip_nonoise_noshadow_nocookie_scattering_technique, false, false, false, true)

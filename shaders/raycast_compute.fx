// Light shafts by rays, computed: one thread for each pixel of the rectangle around a light's outline. A data-centre GPU
// shades fragments with a small part of the chip, and computes with all of it. See raycast.fxh.

#include "raycast.fxh"

float4 gTile;  // xy: the rectangle's first pixel, zw: the pixel after its last

[[vk::image_format("rgba32f")]] RWTexture2D<float4> FloatTarget;
[[vk::image_format("rgba16f")]] RWTexture2D<float4> HalfTarget;

[numthreads(8, 8, 1)]
void cs_main(uint3 id : SV_DispatchThreadID,
             uniform bool bHalf,
             uniform bool bScrollingNoise,
             uniform bool bShadowMapping,
             uniform bool bCookie,
             uniform bool bScattering)
{
    float2 pixel = float2(id.xy) + gTile.xy;
    if (pixel.x >= gTile.z || pixel.y >= gTile.w)
        return;
    float4 light = radiance_of(pixel, bScrollingNoise, bShadowMapping, bCookie, bScattering);
    uint2 at = uint2(pixel);
    if (bHalf)
        HalfTarget[at] = HalfTarget[at] + light;
    else
        FloatTarget[at] = FloatTarget[at] + light;
}

#define RAYCAST_TECHNIQUE(name, half, noise, shadow, cookie, scattering) \
    technique name { pass p0 { ComputeShader = compile cs_5_0 cs_main(half, noise, shadow, cookie, scattering); } }

RAYCAST_TECHNIQUE(clip_noise_shadow_cookie_technique, false, true, true, true, false)
RAYCAST_TECHNIQUE(clip_noise_shadow_nocookie_technique, false, true, true, false, false)
RAYCAST_TECHNIQUE(clip_noise_noshadow_cookie_technique, false, true, false, true, false)
RAYCAST_TECHNIQUE(clip_noise_noshadow_nocookie_technique, false, true, false, false, false)
RAYCAST_TECHNIQUE(clip_nonoise_shadow_cookie_technique, false, false, true, true, false)
RAYCAST_TECHNIQUE(clip_nonoise_shadow_nocookie_technique, false, false, true, false, false)
RAYCAST_TECHNIQUE(clip_nonoise_noshadow_cookie_technique, false, false, false, true, false)
RAYCAST_TECHNIQUE(clip_nonoise_noshadow_nocookie_technique, false, false, false, false, false)
RAYCAST_TECHNIQUE(clip_noise_shadow_cookie_scattering_technique, false, true, true, true, true)
RAYCAST_TECHNIQUE(clip_noise_shadow_nocookie_scattering_technique, false, true, true, false, true)
RAYCAST_TECHNIQUE(clip_noise_noshadow_cookie_scattering_technique, false, true, false, true, true)
RAYCAST_TECHNIQUE(clip_noise_noshadow_nocookie_scattering_technique, false, true, false, false, true)
RAYCAST_TECHNIQUE(clip_nonoise_shadow_cookie_scattering_technique, false, false, true, true, true)
RAYCAST_TECHNIQUE(clip_nonoise_shadow_nocookie_scattering_technique, false, false, true, false, true)
RAYCAST_TECHNIQUE(clip_nonoise_noshadow_cookie_scattering_technique, false, false, false, true, true)
RAYCAST_TECHNIQUE(clip_nonoise_noshadow_nocookie_scattering_technique, false, false, false, false, true)

RAYCAST_TECHNIQUE(half_clip_noise_shadow_cookie_technique, true, true, true, true, false)
RAYCAST_TECHNIQUE(half_clip_noise_shadow_nocookie_technique, true, true, true, false, false)
RAYCAST_TECHNIQUE(half_clip_noise_noshadow_cookie_technique, true, true, false, true, false)
RAYCAST_TECHNIQUE(half_clip_noise_noshadow_nocookie_technique, true, true, false, false, false)
RAYCAST_TECHNIQUE(half_clip_nonoise_shadow_cookie_technique, true, false, true, true, false)
RAYCAST_TECHNIQUE(half_clip_nonoise_shadow_nocookie_technique, true, false, true, false, false)
RAYCAST_TECHNIQUE(half_clip_nonoise_noshadow_cookie_technique, true, false, false, true, false)
RAYCAST_TECHNIQUE(half_clip_nonoise_noshadow_nocookie_technique, true, false, false, false, false)
RAYCAST_TECHNIQUE(half_clip_noise_shadow_cookie_scattering_technique, true, true, true, true, true)
RAYCAST_TECHNIQUE(half_clip_noise_shadow_nocookie_scattering_technique, true, true, true, false, true)
RAYCAST_TECHNIQUE(half_clip_noise_noshadow_cookie_scattering_technique, true, true, false, true, true)
RAYCAST_TECHNIQUE(half_clip_noise_noshadow_nocookie_scattering_technique, true, true, false, false, true)
RAYCAST_TECHNIQUE(half_clip_nonoise_shadow_cookie_scattering_technique, true, false, true, true, true)
RAYCAST_TECHNIQUE(half_clip_nonoise_shadow_nocookie_scattering_technique, true, false, true, false, true)
RAYCAST_TECHNIQUE(half_clip_nonoise_noshadow_cookie_scattering_technique, true, false, false, true, true)
RAYCAST_TECHNIQUE(half_clip_nonoise_noshadow_nocookie_scattering_technique, true, false, false, false, true)

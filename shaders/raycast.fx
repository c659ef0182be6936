// Light shafts by rays, drawn: one fragment for each pixel of a light's outline. See raycast.fxh.

#include "raycast.fxh"

// The vertices outline the light's volume in the picture.
float4 vs_main(float3 position : POSITION0) : POSITION0
{
    return float4(position.xy, 0.5, 1.0);
}

float4 ps_main(float2 pixel : VPOS,
               uniform bool bScrollingNoise,
               uniform bool bShadowMapping,
               uniform bool bCookie,
               uniform bool bScattering) : COLOR0
{
    return radiance_of(pixel, bScrollingNoise, bShadowMapping, bCookie, bScattering);
}

// The techniques have the names of those of slices.fx with the same terms. They add to the target. The ray ends at the
// surface that it meets; there is no depth test.
#define RAYCAST_TECHNIQUE(name, noise, shadow, cookie, scattering) \
    technique name { pass p0 { \
        VertexShader = compile vs_3_0 vs_main(); \
        PixelShader = compile ps_3_0 ps_main(noise, shadow, cookie, scattering); \
        AlphaBlendEnable = TRUE; SrcBlend = ONE; DestBlend = ONE; BlendOp = ADD; \
        ZEnable = FALSE; ZWriteEnable = FALSE; CullMode = NONE; } }

RAYCAST_TECHNIQUE(clip_noise_shadow_cookie_technique,       true, true, true, false)
RAYCAST_TECHNIQUE(clip_noise_shadow_nocookie_technique,     true, true, false, false)
RAYCAST_TECHNIQUE(clip_noise_noshadow_cookie_technique,     true, false, true, false)
RAYCAST_TECHNIQUE(clip_noise_noshadow_nocookie_technique,   true, false, false, false)
RAYCAST_TECHNIQUE(clip_nonoise_shadow_cookie_technique,     false, true, true, false)
RAYCAST_TECHNIQUE(clip_nonoise_shadow_nocookie_technique,   false, true, false, false)
RAYCAST_TECHNIQUE(clip_nonoise_noshadow_cookie_technique,   false, false, true, false)
RAYCAST_TECHNIQUE(clip_nonoise_noshadow_nocookie_technique, false, false, false, false)

RAYCAST_TECHNIQUE(clip_noise_shadow_cookie_scattering_technique,       true, true, true, true)
RAYCAST_TECHNIQUE(clip_noise_shadow_nocookie_scattering_technique,     true, true, false, true)
RAYCAST_TECHNIQUE(clip_noise_noshadow_cookie_scattering_technique,     true, false, true, true)
RAYCAST_TECHNIQUE(clip_noise_noshadow_nocookie_scattering_technique,   true, false, false, true)
RAYCAST_TECHNIQUE(clip_nonoise_shadow_cookie_scattering_technique,     false, true, true, true)
RAYCAST_TECHNIQUE(clip_nonoise_shadow_nocookie_scattering_technique,   false, true, false, true)
RAYCAST_TECHNIQUE(clip_nonoise_noshadow_cookie_scattering_technique,   false, false, true, true)
RAYCAST_TECHNIQUE(clip_nonoise_noshadow_nocookie_scattering_technique, false, false, false, true)

// The phase function of the air.

// The unit vector; 0 for a vector too short to have a direction.
float3 unit(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
}

// The phase function of Henyey and Greenstein (Astrophysical Journal 93, 1941) times 4 pi, which is 1 for g = 0:
//
//   phase = (1 - g^2) / (1 + g^2 - 2 g cos)^(3/2),  cos = dot(fromLamp, toEye)
//
// `fromLamp`: the unit vector from the lamp to the particle; `toEye`: from the particle to the eye. `rest` is 1 - |g|.
// With g > 0 air is brightest in the direction of the lamp.
float phase(float3 fromLamp, float3 toEye, float g, float rest)
{
    // 1 + g^2 - 2 g cos = (1 - |g|)^2 + |g| |a -+ b|^2 with the unit vectors a and b: no term cancels where |g| and
    // cos are near 1.
    float away = g < 0.0 ? -1.0 : 1.0;
    float strength = abs(g);
    float3 chord = fromLamp - away * toEye;
    float base = rest * rest + strength * dot(chord, chord);
    return rest / base * ((1.0 + strength) / sqrt(base));
}

// The shadow map lookup, for air and surfaces.

// The share of the four nearest texels that let the light through: compared first, then filtered bilinearly.
// `size` is the map's, in texels a side. `depth` and the map are reversed, so nearer to the light is greater.
float light_through(sampler2D map, float size, float2 uv, float depth)
{
    float2 texel = uv * size - 0.5;
    float2 corner = floor(texel);
    float2 part = texel - corner;
    float2 uv00 = (corner + 0.5) / size;
    float2 uv11 = (corner + 1.5) / size;
    float s00 = tex2Dlod(map, float4(uv00, 0.0, 0.0)).r;
    float s10 = tex2Dlod(map, float4(uv11.x, uv00.y, 0.0, 0.0)).r;
    float s01 = tex2Dlod(map, float4(uv00.x, uv11.y, 0.0, 0.0)).r;
    float s11 = tex2Dlod(map, float4(uv11, 0.0, 0.0)).r;
    float4 lit = step(float4(s00, s10, s01, s11), float4(depth, depth, depth, depth));
    float2 rows = lerp(lit.xz, lit.yw, part.x);
    return lerp(rows.x, rows.y, part.y);
}

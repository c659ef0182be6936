// The light's view of the occluders in its cone: depth only, reversed (1 at the near plane, 0 at the far
// plane), cleared to 0.

float4x4 gClipFromMesh;

float4 vs_main(float3 position : POSITION0) : POSITION0
{
    return mul(gClipFromMesh, float4(position, 1.0));
}

technique shadow_map_technique
{
    pass p0
    {
        VertexShader = compile vs_3_0 vs_main();
        ZEnable = TRUE;
        ZWriteEnable = TRUE;
        ZFunc = GREATER;
        CullMode = NONE;  // an open sheet throws a shadow from either side
    }
}

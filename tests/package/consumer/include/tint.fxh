float4 gTint;

// Products without rounding error, in 32-bit floats.
//
// T. J. Dekker, "A Floating-Point Technique for Extending the Available Precision" (Numerische Mathematik 18, 1971),
// with the split done on the bits. Each half has at most 12 significant bits, so the product of two halves is exact.
// `precise` (NoContraction in SPIR-V) keeps drivers from regrouping the sums: Mesa takes a * b + a * c for a * (b + c).

// The upper 12 bits of the significand of `a`; a - upper_half(a) is exact.
float upper_half(float a)
{
    return asfloat(asuint(a) & 0xfffff000u);
}

// a * b - c * d. The error stays below 2^-34 of the larger product, also where the products cancel.
float difference_of_products(float a, float b, float c, float d)
{
    precise float a1 = upper_half(a), b1 = upper_half(b), c1 = upper_half(c), d1 = upper_half(d);
    precise float a0 = a - a1, b0 = b - b1, c0 = c - c1, d0 = d - d1;
    precise float difference = (a1 * b1 - c1 * d1) +
                               (((a1 * b0 - c1 * d0) + (a0 * b1 - c0 * d1)) + (a0 * b0 - c0 * d0));
    return difference;
}

// The cross product, each component as above.
float3 precise_cross(float3 a, float3 b)
{
    return float3(difference_of_products(a.y, b.z, a.z, b.y),
                  difference_of_products(a.z, b.x, a.x, b.z),
                  difference_of_products(a.x, b.y, a.y, b.x));
}

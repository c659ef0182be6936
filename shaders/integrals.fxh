// The integral of 1 / d^2 along a view ray, in a form that holds in 32-bit floats.

// atan2(y, x) / y for y >= 0; 1 / x for y = 0. A difference of two arctangents loses all digits where both are nearly
// the same. Here the quotient of the two sides is the polynomial's argument, so nothing cancels: 3e-7 relative.
float arc_over_side(float y, float x)
{
    bool steep = y > abs(x);
    float q = steep ? x / y : y / x;
    float z = q * q;
    // atan(sqrt z) / sqrt z on [0, 1].
    float p = 0.999999985 + z * (-0.333330733 + z * (0.199926194 + z * (-0.142036445 + z * (0.10640934 +
              z * (-0.0750429445 + z * (0.0426915181 + z * (-0.0160686282 + z * 0.00284988943)))))));
    if (steep)
        return (1.57079633 - q * p) / y;
    return x < 0.0 ? (3.14159265 + q * p) / y : p / x;
}

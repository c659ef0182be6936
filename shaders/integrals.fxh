// The integrals along a view ray that have a closed form, in forms that hold in 32-bit floats.

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

// The integral over x in [-1, 1] of x / (1 + s x)^2, |s| < 1: (2 atanh s - 2 s / (1 - s^2)) / s^2. For small s its terms
// cancel; its series does not.
float first_moment(float s)
{
    float z = s * s;
    if (z < 0.09)
        return s * (-1.33333333 + z * (-1.6 + z * (-1.71428571 + z * (-1.77777778 + z * (-1.81818182 +
               z * (-1.84615385 + z * -1.86666667))))));
    return (log((1.0 + s) / (1.0 - s)) - 2.0 * s / (1.0 - z)) / z;
}

// The inverse square law along a straight ray.
#pragma once

namespace tyndall::study {

/// Integral of ds / (h^2 + s^2) from a to b, a <= b: the light that a lamp at distance h sends to the ray, per candela.
/// Accurate as h goes to 0, where differences of atan lose all digits. Infinite only if h is 0 and the lamp lies within
/// [a, b].
double inverseSquareIntegral(double a, double b, double h);

/// The substitution that removes the lamp's peak from the integral over [a, b], which must not have 0 inside:
///
///   integral of g(s) ds / (h^2 + s^2) = measure * integral over x in [0, 1] of g(at(x)) dx.
///
/// It is the angle seen from the lamp ("equi-angular": C. Kulla, M. Fajardo, "Importance Sampling Techniques for
/// Path Tracing in Participating Media", EGSR 2012), written so that it turns into 1/s as h goes to 0.
class AngleFromLamp {
public:
    AngleFromLamp(double a, double b, double h);
    double measure() const { return measure_; }
    double at(double x) const;

private:
    double a_, b_, h_, angle_, measure_;
};

}  // namespace tyndall::study

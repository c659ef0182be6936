// Interval arithmetic over a shader's possible results in binary32: every operation gives the exact result of its
// operands' bounds, widened by the rounding that Vulkan's precision table ("Precision and Operation of SPIR-V
// Instructions") allows that operation. A value evaluated in it contains every result that a conforming implementation
// may produce, contracted to fused multiply-adds or not.
#pragma once

#include <algorithm>
#include <cmath>

namespace tyndall::test {

/// Half a unit in the last place of binary32, relative: the error of one correctly rounded operation.
inline constexpr double kFloatEps = 0x1p-24;

struct Interval {
    double lo = 0.0, hi = 0.0;

    double mid() const { return 0.5 * (lo + hi); }
    double radius() const { return 0.5 * (hi - lo); }
    bool contains(double x) const { return lo <= x && x <= hi; }
};

inline Interval exactly(double x) {
    return {x, x};
}

inline Interval around(double x, double error) {
    return {x - error, x + error};
}

/// Widened by `ulps` half-ulps relative to its magnitude; below the normal range a result may be flushed.
inline Interval rounded(Interval a, double ulps = 1.0) {
    const double slack = ulps * kFloatEps * std::max(std::abs(a.lo), std::abs(a.hi));
    return {a.lo - slack, a.hi + slack};
}

inline Interval operator+(Interval a, Interval b) {
    return rounded({a.lo + b.lo, a.hi + b.hi});
}

inline Interval operator-(Interval a, Interval b) {
    return rounded({a.lo - b.hi, a.hi - b.lo});
}

inline Interval operator*(Interval a, Interval b) {
    const auto [lo, hi] = std::minmax({a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi});
    return rounded({lo, hi});
}

/// `b` must not contain 0. The error of OpFDiv may be 2.5 ulp, five half-ulps.
inline Interval operator/(Interval a, Interval b) {
    const auto [lo, hi] = std::minmax({a.lo / b.lo, a.lo / b.hi, a.hi / b.lo, a.hi / b.hi});
    return rounded({lo, hi}, 5.0);
}

/// x*x, with the knowledge that both factors are equal.
inline Interval square(Interval a) {
    const auto [small, large] = std::minmax({std::abs(a.lo), std::abs(a.hi)});
    return rounded({a.lo <= 0.0 && a.hi >= 0.0 ? 0.0 : small * small, large * large});
}

/// sqrt of a non-negative interval; Vulkan derives it from 1 / inversesqrt (2 ulp and 2.5 ulp).
inline Interval squareRoot(Interval a) {
    return rounded({std::sqrt(std::max(a.lo, 0.0)), std::sqrt(std::max(a.hi, 0.0))}, 9.0);
}

inline Interval clamped(Interval a, double lo, double hi) {
    return {std::clamp(a.lo, lo, hi), std::clamp(a.hi, lo, hi)};
}

inline Interval hull(Interval a, Interval b) {
    return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

}  // namespace tyndall::test

#include "inverse_square.h"

#include <algorithm>
#include <cmath>

namespace tyndall::study {
namespace {

// Below this tangent, three terms of atan's series leave less than 1e-17 of it.
constexpr double seriesBelow = 1e-3;

}  // namespace

double inverseSquareIntegral(double a, double b, double h) {
    // atan(b / h) - atan(a / h) as the one angle between both directions: nothing cancels.
    const double across = h * (b - a), along = h * h + a * b;
    if (along > 0.0 && across < seriesBelow * along) {
        const double x = across / along;
        return (b - a) / along * (1.0 - x * x * (1.0 / 3.0 - x * x / 5.0));
    }
    return std::atan2(across, along) / h;
}

AngleFromLamp::AngleFromLamp(double a, double b, double h)
    : a_(a), b_(b), h_(h), angle_(std::atan2(h * (b - a), h * h + a * b)), measure_(inverseSquareIntegral(a, b, h)) {}

double AngleFromLamp::at(double x) const {
    // With w = tan(angle from a) / h: s = (a + h^2 w) / (1 - a w). For small angles tan(x angle) / h is
    // x * measure up to the series' second term, which also covers h = 0.
    const double angle = x * angle_;
    const double w = angle_ < 1e-7 ? x * measure_ : std::tan(angle) / h_;
    return std::clamp((a_ + h_ * h_ * w) / (1.0 - a_ * w), a_, b_);
}

}  // namespace tyndall::study

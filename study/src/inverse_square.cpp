#include "inverse_square.h"

#include <algorithm>
#include <cmath>

namespace tyndall::study {
namespace {

// Below this value an angle and its tangent are equal as doubles.
constexpr double smallTangent = 1e-8;

}  // namespace

double inverseSquareIntegral(double a, double b, double h) {
    // atan(b / h) - atan(a / h), computed as one angle between both directions to avoid cancellation.
    const double across = h * (b - a), along = h * h + a * b;
    if (along > 0.0 && across < smallTangent * along) return (b - a) / along;
    return std::atan2(across, along) / h;
}

AngleFromLamp::AngleFromLamp(double a, double b, double h)
    : a_(a), b_(b), h_(h), angle_(std::atan2(h * (b - a), h * h + a * b)), measure_(inverseSquareIntegral(a, b, h)) {}

double AngleFromLamp::at(double x) const {
    // With w = tan(angle from a) / h: s = (a + h^2 w) / (1 - a w). For small angles, h = 0 among them, w is
    // x * measure.
    const double angle = x * angle_;
    const double w = angle_ < smallTangent ? x * measure_ : std::tan(angle) / h_;
    return std::clamp((a_ + h_ * h_ * w) / (1.0 - a_ * w), a_, b_);
}

}  // namespace tyndall::study

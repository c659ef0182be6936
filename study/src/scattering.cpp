#include "scattering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tyndall::study {
namespace {

// sqrt(h^2 + s^2) + s without cancellation for negative s.
double distancePlus(double h, double s) {
    const double d = std::hypot(h, s);
    return s < 0.0 ? h * (h / (d - s)) : d + s;
}

// exp(-746) is 0 in doubles.
constexpr double darkest = 746.0;

}  // namespace

Scattering::Scattering(const Light& light, const LightRay& ray)
    : strength_(std::abs(light.anisotropy)),
      sign_(light.anisotropy < 0.0 ? -1.0 : 1.0),
      extinction_(light.albedo ? light.density / *light.albedo : 0.0),
      distance_(ray.distance),
      footLength_(ray.footLength) {}

double Scattering::path(double s) const {
    return footLength_ + distancePlus(distance_, s);
}

double Scattering::at(double s) const {
    // 1 + g^2 - 2 g cos = (1 - |g|)^2 + 2 |g| (1 - sign cos), and 1 - sign cos = (d + sign s) / d: no term cancels.
    const double narrow = 1.0 - strength_;
    const double turned = distancePlus(distance_, sign_ * s) / std::hypot(distance_, s);
    const double base = narrow * narrow + 2.0 * strength_ * turned;
    const double phase = narrow * (1.0 + strength_) / (base * std::sqrt(base));
    return phase * std::exp(-extinction_ * path(s));
}

void Scattering::addBreakpoints(std::vector<double>& places, Span span) const {
    const auto add = [&](double s) {
        if (s > span.begin && s < span.end) places.push_back(s);
    };
    // The peak lies where the ray points towards the lamp, or away from it, and is 1 - |g| radians wide. The ray has an
    // angle `a` to that direction at h / tan(a) from the foot.
    if (strength_ > 0.0)
        for (double a = 1.0 - strength_; a < 0.5 * std::numbers::pi; a *= 4.0) add(-sign_ * distance_ / std::tan(a));
    // path(s) - footLength = c at s = (c^2 - h^2) / (2 c); it grows with s.
    if (extinction_ > 0.0) {
        const double begin = distancePlus(distance_, span.begin);
        for (double fall = 1.0; fall < 2.0 * darkest; fall *= 2.0) {
            const double c = begin + fall / extinction_;
            add(0.5 * (c - distance_ * (distance_ / c)));
        }
    }
}

double Scattering::conditioning(Span span) const {
    if (none()) return 0.0;
    // The error of exp(-x) is x times the relative error of x; for large x the value is 0. Both paths are at most
    // path() long.
    const double fall = std::min(extinction_ * path(span.end), darkest);
    // The base's error is the error of the angle times its derivative; the base is at least (1 - |g|)^2: 3 |g| / (1 -
    // |g|). The error of angles is the rounding of the eye's position, seen from the lamp.
    const double nearest = std::max({span.begin, -span.end, 0.0});
    const double lengths = std::abs(footLength_) + std::max(std::abs(span.begin), std::abs(span.end)) + distance_;
    const double angle = lengths / std::hypot(distance_, nearest);
    return 1.0 + fall + 3.0 * strength_ / (1.0 - strength_) * angle;
}

}  // namespace tyndall::study

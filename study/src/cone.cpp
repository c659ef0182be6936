#include "cone.h"

#include <algorithm>
#include <cmath>

namespace tyndall::study {
namespace {

// The minimum width of the edge of full light, as in the extension: a cone with equal angles has it, too.
double fullCosine(const Cone& cone) {
    return std::cos(cone.outer) + std::max(0.001, std::cos(cone.inner) - std::cos(cone.outer));
}

}  // namespace

double coneFalloff(const Cone& cone, double cosine) {
    const double dark = std::cos(cone.outer);
    const double share = std::clamp((cosine - dark) / (fullCosine(cone) - dark), 0.0, 1.0);
    return share * share;
}

bool inFullLight(const Cone& cone, double cosine) {
    return cosine > fullCosine(cone);
}

void addCrossings(std::vector<double>& places, const Cone& cone, const LightRay& ray, Span span) {
    // axis(s) = k |P(s)| squared: (c1^2 - k^2) s^2 + 2 c0 c1 s + c0^2 - k^2 h^2 = 0. Squaring adds the roots of the
    // cone behind the lamp, outside of all spans.
    const double c0 = -ray.foot.z, c1 = -ray.direction.z, h = ray.distance;
    for (const double k : {std::cos(cone.outer), fullCosine(cone)}) {
        const double a = c1 * c1 - k * k, b = c0 * c1, c = c0 * c0 - k * k * h * h;
        const double discriminant = b * b - a * c;
        if (!(discriminant > 0.0)) continue;
        const double q = -(b + std::copysign(std::sqrt(discriminant), b));  // the root that does not cancel
        for (const double s : {q / a, c / q})
            if (s > span.begin && s < span.end) places.push_back(s);
    }
}

}  // namespace tyndall::study

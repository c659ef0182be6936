#include "light_integral.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cone.h"
#include "inverse_square.h"
#include "scattering.h"

namespace tyndall::study {
namespace {

// Phase of a scrolling texture in [0, 1): whole repeats are dropped, because they only cost precision.
double phase(double turns) {
    return turns - std::floor(turns);
}

TexelPath noisePath(const ReferenceLight& light, const Projected& uv, glm::dvec2 scroll, double time) {
    const glm::dvec2 scale = light.light.noise->scale;
    return texelPath(light.noise,
                     {scaled(uv.u, scale.x, phase(scroll.x * time)), scaled(uv.v, scale.y, phase(scroll.y * time))});
}

/// The product of cookie, shadow, noise and cone within a stretch in which every texture stays in one cell.
struct Masks {
    std::optional<Cell> cookie, noise1, noise2, shadow;
    std::array<bool, 4> corners{};
    double gain = 1.0;
    const Cone* cone = nullptr;  // null where the stretch is dark or in full light
    const LightRay* ray = nullptr;

    glm::dvec3 at(double s) const {
        const double reciprocal = 1.0 / ray->axis(s);
        glm::dvec3 mask(cone ? coneFalloff(*cone, ray->cosine(s)) : 1.0);
        if (shadow) {
            const std::array<double, 4> weight = shadow->weights(s, reciprocal);
            double through = 0.0;
            for (int i = 0; i < 4; ++i) through += corners[i] ? weight[i] : 0.0;
            mask *= std::max(through, 0.0);  // crossings are rounded: a weight may be negative by one ulp
        }
        if (noise1)
            mask *= gain * noise1->blend(noise1->weights(s, reciprocal), 0) *
                    noise2->blend(noise2->weights(s, reciprocal), 1);
        if (cookie) {
            const std::array<double, 4> weight = cookie->weights(s, reciprocal);
            mask *= glm::dvec3(cookie->blend(weight, 0), cookie->blend(weight, 1), cookie->blend(weight, 2));
        }
        return mask;
    }

    bool constant() const {
        return !cone && !shadow && (!noise1 || (noise1->uniform(1) && noise2->uniform(2))) &&
               (!cookie || cookie->uniform(3));
    }
};

class Integral {
public:
    Integral(const ReferenceLight& light, const LightRay& ray, double accuracy)
        : intensity_(light.light.intensity),
          ambient_(light.light.ambient),
          ray_(ray),
          scattering_(light.light, ray),
          accuracy_(accuracy) {}

    void add(Span span, const Masks& masks) {
        if (masks.constant()) {
            addConstant(span, masks.at(span.middle()));
            return;
        }
        flush();
        addVarying(span, [&](double s) { return masks.at(s); });
    }

    Quadrature result() {
        flush();
        return sum_;
    }

private:
    // Neighbours with the same value become one integral.
    void addConstant(Span span, const glm::dvec3& value) {
        if (!pending_.empty() && pending_.end == span.begin && value == value_) {
            pending_.end = span.end;
            return;
        }
        flush();
        pending_ = span;
        value_ = value;
    }

    void flush() {
        if (!pending_.empty() && !scattering_.none()) {
            addVarying(pending_, [this](double) { return value_; });
        } else if (!pending_.empty()) {
            const double light = intensity_ * inverseSquareIntegral(pending_.begin, pending_.end, ray_.distance) +
                                 ambient_ * (pending_.end - pending_.begin);
            sum_.value += value_ * light;
        }
        pending_ = {};
    }

    // `mask` (double -> dvec3) is smooth within `span`.
    template <class Mask>
    void addVarying(Span span, const Mask& mask) {
        places_.assign({span.begin, span.end});
        // The angle from the lamp has a corner at the foot, so each side is integrated separately.
        if (span.begin < 0.0 && span.end > 0.0) places_.push_back(0.0);
        scattering_.addBreakpoints(places_, span);
        std::sort(places_.begin(), places_.end());
        for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
            const Span piece{places_[i], places_[i + 1]};
            if (!piece.empty()) addSmooth(piece, mask);
        }
    }

    template <class Mask>
    void addSmooth(Span span, const Mask& mask) {
        const AngleFromLamp angle(span.begin, span.end, ray_.distance);
        const double h2 = ray_.distance * ray_.distance;
        const auto integrand = [&](double x) {
            const double s = angle.at(x);
            const glm::dvec3 lit = mask(s) * (intensity_ + ambient_ * (h2 + s * s));
            return scattering_.none() ? lit : lit * scattering_.at(s);
        };
        Quadrature part = integrate(integrand, 0.0, 1.0, accuracy_);
        sum_.value += angle.measure() * part.value;
        sum_.error += angle.measure() * part.error;
        sum_.evaluations += part.evaluations;
    }

    double intensity_, ambient_;
    const LightRay& ray_;
    Scattering scattering_;
    double accuracy_;
    Quadrature sum_;
    Span pending_;
    std::vector<double> places_;
    glm::dvec3 value_{0.0};
};

}  // namespace

TexturePaths texturePaths(const ReferenceLight& light, const LightRay& ray, double time) {
    const Projected uv = project(light.light, ray);
    TexturePaths paths{};
    if (light.light.cookie) paths.cookie = texelPath(light.cookie, uv);
    if (light.light.noise) {
        paths.noise1 = noisePath(light, uv, light.light.noise->scroll1, time);
        paths.noise2 = noisePath(light, uv, light.light.noise->scroll2, time);
    }
    return paths;
}

Quadrature lightIntegral(const ReferenceLight& light, const LightRay& ray, const TexturePaths& paths,
                         const TexelPath& shadow, const ShadowMap& map, const std::vector<LitSpan>& lit,
                         double accuracy) {
    Integral integral(light, ray, accuracy);
    std::vector<double> places;
    for (const LitSpan& stretch : lit) {
        places.assign(1, stretch.span.begin);
        if (light.light.cookie) addCrossings(places, paths.cookie, light.cookie, Address::Clamp, stretch.span);
        if (light.light.noise) {
            addCrossings(places, paths.noise1, light.noise, Address::Wrap, stretch.span);
            addCrossings(places, paths.noise2, light.noise, Address::Wrap, stretch.span);
        }
        if (light.cone) addCrossings(places, *light.cone, ray, stretch.span);
        places.push_back(stretch.span.end);
        std::sort(places.begin(), places.end());
        for (std::size_t i = 0; i + 1 < places.size(); ++i) {
            const Span span{places[i], places[i + 1]};
            if (span.empty()) continue;
            if (light.cone && coneFalloff(*light.cone, ray.cosine(span.middle())) == 0.0) continue;
            Masks masks;
            masks.ray = &ray;
            if (light.cone && !inFullLight(*light.cone, ray.cosine(span.middle()))) masks.cone = &*light.cone;
            if (light.light.cookie) masks.cookie.emplace(light.cookie, paths.cookie, Address::Clamp, span.middle());
            if (light.light.noise) {
                masks.gain = light.light.noise->gain;
                masks.noise1.emplace(light.noise, paths.noise1, Address::Wrap, span.middle());
                masks.noise2.emplace(light.noise, paths.noise2, Address::Wrap, span.middle());
            }
            if (!stretch.full()) {
                masks.shadow.emplace(map.stored, shadow, Address::Clamp, span.middle());
                masks.corners = stretch.corners;
            }
            integral.add(span, masks);
        }
    }
    return integral.result();
}

}  // namespace tyndall::study

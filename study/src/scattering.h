// How air that is neither even nor clear changes what a ray gathers: phase function and transmittance.
#pragma once

#include <vector>

#include "light_ray.h"

namespace tyndall::study {

/// phase * transmittance along one ray, relative to air that scatters evenly and takes no light away:
///
///   phase = (1 - g^2) / (1 + g^2 - 2 g cos)^(3/2)      (L. Henyey, J. Greenstein, Astrophysical Journal 93, 1941,
///                                                       times 4 pi: 1 for g = 0)
///   transmittance = exp(-extinction * (lamp to particle + particle to eye))
///
/// cos is that of the angle by which light turns, so with s from the ray's foot it is -s / sqrt(h^2 + s^2): every
/// particle sends its light back along the ray.
class Scattering {
public:
    Scattering(const Light& light, const LightRay& ray);

    /// Exactly 1 everywhere.
    bool none() const { return strength_ == 0.0 && extinction_ == 0.0; }

    double at(double s) const;

    /// Adds the places within `span` between which the factor changes smoothly on the scale of the stretch: around
    /// the phase function's peak, and where the transmittance has fallen to exp(-1), exp(-2), exp(-4) and so on of
    /// what it is at the span's begin. In no order.
    void addBreakpoints(std::vector<double>& places, Span span) const;

    /// What rounding leaves of at() within `span`, in units of the rounding of a few operations, relative.
    double conditioning(Span span) const;

private:
    double path(double s) const;  ///< metres from the lamp to the ray and back to the eye

    double strength_, sign_;  ///< |g| and g's sign
    double extinction_;       ///< 1/m
    double distance_;         ///< of the ray from the lamp, metres
    double footLength_;       ///< metres from the eye, or the plane of depth 0, to the foot
};

}  // namespace tyndall::study

// The scattering term along a ray: phase function and transmittance.
#pragma once

#include <vector>

#include "light_ray.h"

namespace tyndall::study {

/// phase * transmittance along one ray, relative to air that scatters evenly and absorbs nothing:
///
///   phase = (1 - g^2) / (1 + g^2 - 2 g cos)^(3/2)      (L. Henyey, J. Greenstein, Astrophysical Journal 93, 1941,
///                                                       times 4 pi: 1 for g = 0)
///   transmittance = exp(-extinction * (lamp to particle + particle to eye))
///
/// cos belongs to the angle by which light turns. With s from the ray's foot it is -s / sqrt(h^2 + s^2), because every
/// particle sends its light back along the ray.
class Scattering {
public:
    Scattering(const Light& light, const LightRay& ray);

    /// Exactly 1 everywhere.
    bool none() const { return strength_ == 0.0 && extinction_ == 0.0; }

    double at(double s) const;

    /// Adds breakpoints within `span`, in no order; between them the factor is smooth on the scale of the stretch. They
    /// lie around the phase function's peak, and where the transmittance is exp(-1), exp(-2), exp(-4) and so on of its
    /// value at the span's begin.
    void addBreakpoints(std::vector<double>& places, Span span) const;

    /// Relative rounding error of at() within `span`, in units of the rounding of a few operations.
    double conditioning(Span span) const;

private:
    double path(double s) const;  ///< metres from the lamp to the ray and back to the eye

    double strength_, sign_;  ///< |g| and g's sign
    double extinction_;       ///< 1/m
    double distance_;         ///< of the ray from the lamp, metres
    double footLength_;       ///< metres from the eye, or the plane of depth 0, to the foot
};

}  // namespace tyndall::study

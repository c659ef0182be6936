// A second, independent estimate of the reference: unbiased, slow, and made of point tests only.
#pragma once

#include <study/reference.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <string>

namespace tyndall::study {

struct Estimate {
    glm::dvec3 mean{0.0};           ///< radiance
    glm::dvec3 standardError{0.0};  ///< of the mean
};

/// Radiance at the centre of pixel x, y from `samples` points a light, spread along the whole view ray in
/// proportion to 1 / d^2 ("equi-angular": C. Kulla, M. Fajardo, EGSR 2012): 32 separate stratified estimates, whose
/// spread gives the error. Each point is tested by itself for the light's volume, the lamp's visibility and the
/// textures' values: no breakpoints, no clipping, no closed forms. `seed` decides the points.
/// Errors: those of reference(); fewer than 32 samples.
Result<Estimate> monteCarlo(const ReferenceScene& scene, int x, int y, int samples, std::uint64_t seed);

}  // namespace tyndall::study

// A second, independent estimate of the reference: unbiased, slow, and made of nothing but point tests.
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
/// proportion to 1 / d^2 ("equi-angular": C. Kulla, M. Fajardo, EGSR 2012): 32 estimates of their own, stratified
/// each, whose spread gives the error. Whether a point lies in the light's volume, sees the lamp and what the textures
/// hold there is asked of each point by itself; no breakpoints, no clipping, no closed forms. `seed` decides the
/// points.
///
/// Errors: as reference(); fewer than 32 samples.
Result<Estimate> monteCarlo(const ReferenceScene& scene, int x, int y, int samples,
                                               std::uint64_t seed);

}  // namespace tyndall::study

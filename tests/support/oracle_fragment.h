// The contribution of one slice to one pixel.
#pragma once

#include <array>
#include <vector>

#include "oracle.h"
#include "oracle_volume.h"

namespace tyndall::test {

/// Data that all fragments of a shot share.
struct FragmentContext {
    const Shot& shot;
    std::vector<HalfSpace> volume;  ///< view space
    glm::dmat4 lightFromView;
    double slabThickness;   ///< metres
    double attributeError;  ///< metres, of an interpolated light-space position
    double edgePixels;      ///< distance from a polygon's edge beyond which coverage is certain
};

FragmentContext fragmentContext(const Shot& shot, const std::vector<HalfSpace>& volume,
                                const std::vector<glm::dvec3>& corners, double slabThickness);

enum class Seen { No, Maybe, Yes };

/// Whether the slice at `depth` metres covers the centre of a pixel, in front of the scene.
Seen coverage(const FragmentContext& context, int x, int y, double depth);

/// The factors of the shot's terms at one point: 1 if the shot lacks the term. Noise is relative to the air of a shot
/// without it.
struct Masks {
    Interval noise, shadow, scattering;
    std::array<Interval, 3> cookie;
};
Masks masks(const FragmentContext& context, int x, int y, double depth);

/// Radiance that the fragment adds if it is seen; the fourth is the grey value.
std::array<Interval, 4> radiance(const FragmentContext& context, int x, int y, double depth);

}  // namespace tyndall::test

// What one slice adds at one pixel.
#pragma once

#include <array>
#include <vector>

#include "oracle.h"
#include "oracle_volume.h"

namespace tyndall::test {

/// What all fragments of a shot share.
struct FragmentContext {
    const Shot& shot;
    std::vector<HalfSpace> volume;  ///< view space
    glm::dmat4 lightFromView;
    double slabThickness;   ///< metres
    double attributeError;  ///< metres, of an interpolated light-space position
    double edgePixels;      ///< how far from a polygon's edge a pixel's coverage is certain
};

FragmentContext fragmentContext(const Shot& shot, const std::vector<HalfSpace>& volume,
                                const std::vector<glm::dvec3>& corners, double slabThickness);

enum class Seen { No, Maybe, Yes };

/// Whether the slice at `depth` metres covers the centre of a pixel, in front of the scene.
Seen coverage(const FragmentContext& context, int x, int y, double depth);

/// What the terms of the shot leave of the light at one point: 1 where the shot lacks the term. Noise is
/// relative to the air of a shot without it.
struct Masks {
    Interval noise, shadow, scattering;
    std::array<Interval, 3> cookie;
};
Masks masks(const FragmentContext& context, int x, int y, double depth);

/// Radiance that the fragment adds where it is seen; the fourth is the grey value.
std::array<Interval, 4> radiance(const FragmentContext& context, int x, int y, double depth);

}  // namespace tyndall::test

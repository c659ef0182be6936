// The independent reference for one permutation: what every slice adds to every pixel, from the formula at
// the head of shaders/slices.fx and the conventions of its comments, in double precision and without a
// line of the runtime's. Each answer is an interval that every correct rendering in binary32 lies in; see
// oracle_fragment.cpp for how wide it is, and why.
#pragma once

#include <tyndall/light.h>

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "interval.h"
#include "texture.h"

namespace tyndall::test {

/// A camera in the oracle's own words. Depth is reversed: 1 at nearPlane, 0 at farPlane.
struct Eye {
    glm::dmat4 worldFromView{1.0};
    double verticalFov = 0.9;  ///< radians; unused when orthographic
    double halfHeight = 2.0;   ///< metres; used when orthographic
    double nearPlane = 0.1, farPlane = 100.0;
    bool orthographic = false;
};

/// Everything that one light's picture depends on.
struct Shot {
    Light light;  ///< `cookie`, `shadow`, `noise`, `anisotropy` and `albedo` say which terms there are
    Eye eye;
    int width = 128, height = 128;
    int slices = 16;
    bool article = false;  ///< the published constants
    bool routed = false;   ///< one grey value
    double time = 0.0;
    double farthestSurface = 1e300;  ///< View::sceneDepth
    double shadowBias = 0.0;
    bool quads = false;            ///< cut out of quads around the volume, rather than drawn as polygons
    double triangleStretch = 2.5;  ///< X L / area2 of the triangles drawn, see attributeErrorOf()
    Texture cookieMap, noiseMap;
    Texture shadowMap;   ///< one channel, stored depth
    Texture sceneDepth;  ///< one channel, stored depth, width x height; empty: nothing in the way
};

/// What the slices add up to at one pixel, in radiance (not scaled to a target's range).
struct PixelSum {
    std::array<Interval, 4> rgba{};                    ///< all slices; alpha is the grey value
    std::array<std::array<Interval, 4>, 4> quarter{};  ///< [i mod 4], slice 0 the farthest
    int fragments = 0;                                 ///< slices that may be seen here
    std::array<double, 4> runningTotals{};             ///< sum over those slices of the largest total so far
    std::array<double, 4> largest{};                   ///< the largest single contribution
};

struct OracleImage {
    int width = 0, height = 0;
    double nearDepth = 0.0, farDepth = 0.0;
    std::vector<PixelSum> pixels;  ///< rows from the top

    const PixelSum& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

OracleImage oracle(const Shot& shot);

/// The direction of world space's ray, for one metre of depth, and the point it starts from.
struct Ray {
    glm::dvec3 origin, perMetre;  ///< view space; point at depth z: origin + z * perMetre
};
Ray pixelRay(const Shot& shot, double pixelX, double pixelY);

/// Reversed depth as a D32 depth buffer of this eye stores it.
double storedSceneDepth(const Eye& eye, double depth);

/// Reversed depth as the shadow map stores a surface `axis` metres from the lamp along its direction.
double storedShadowDepth(const Light& light, double axis);

}  // namespace tyndall::test

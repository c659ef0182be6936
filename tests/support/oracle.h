// The independent reference for one permutation: the contribution of every slice to every pixel, from the formula and
// the conventions in the comments of shaders/slices.fx, in double precision and without code of the runtime. Each
// result is an interval that holds every correct rendering in binary32; oracle_fragment.cpp derives its width.
#pragma once

#include <tyndall/light.h>

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "interval.h"
#include "texture.h"

namespace tyndall::test {

/// The oracle's camera. Depth is reversed: 1 at nearPlane, 0 at farPlane.
struct Eye {
    glm::dmat4 worldFromView{1.0};
    double verticalFov = 0.9;  ///< radians; unused when orthographic
    double halfHeight = 2.0;   ///< metres; used when orthographic
    double nearPlane = 0.1, farPlane = 100.0;
    bool orthographic = false;
};

/// Everything that one light's picture depends on.
struct Shot {
    Light light;  ///< `cookie`, `shadow`, `noise`, `anisotropy` and `albedo` decide the terms
    Eye eye;
    int width = 128, height = 128;
    int slices = 16;
    bool article = false;  ///< the published constants
    bool routed = false;   ///< one grey value
    double time = 0.0;
    double farthestSurface = 1e300;  ///< View::sceneDepth
    double shadowBias = 0.0;
    bool quads = false;            ///< cut from quads around the volume instead of drawn as polygons
    double triangleStretch = 2.5;  ///< X L / area2 of the triangles drawn, see attributeErrorOf()
    Texture cookieMap, noiseMap;
    Texture shadowMap;   ///< one channel, stored depth
    Texture sceneDepth;  ///< one channel, stored depth, width x height; empty: no surface
};

/// The sum of the slices at one pixel, in radiance (not scaled to a target's range).
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

/// A view ray: its direction for one metre of depth, and its origin.
struct Ray {
    glm::dvec3 origin, perMetre;  ///< view space; point at depth z: origin + z * perMetre
};
Ray pixelRay(const Shot& shot, double pixelX, double pixelY);

/// Reversed depth as a D32 depth buffer of this eye stores it.
double storedSceneDepth(const Eye& eye, double depth);

/// Reversed depth as the shadow map stores a surface `axis` metres from the lamp along its direction.
double storedShadowDepth(const Light& light, double axis);

}  // namespace tyndall::test

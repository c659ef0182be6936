// The reference at one pixel: every light's integral along the ray through its centre.
#pragma once

#include <study/reference.h>

#include <vector>

#include "shadow.h"
#include "surfaces.h"
#include "triangle_tree.h"

namespace tyndall::study {

/// A scene and the data that are computed from it once. `scene` must outlive it.
struct PreparedScene {
    const ReferenceScene& scene;
    Surfaces surfaces;                    ///< Ideal
    std::vector<TriangleTree> occluders;  ///< Ideal, by light
    std::vector<ShadowMap> shadowMaps;    ///< Hardware, by light
};

PreparedScene prepare(const ReferenceScene& scene);

/// The visible part of the ray through pixel x, y: metres from depth 0.
Span visible(const PreparedScene& prepared, const ViewRay& ray, int x, int y);

struct Pixel {
    glm::dvec3 radiance{0.0}, error{0.0};
    std::uint64_t evaluations = 0;
};

Pixel integratePixel(const PreparedScene& prepared, int x, int y, double accuracy);

}  // namespace tyndall::study

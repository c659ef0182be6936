#include "needs/brightness.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "shape/attenuation.h"
#include "slice_constants.h"

namespace tyndall {
namespace {

double thickest(const Slabs& slabs) {
    if (slabs.count <= 0) return 0.0;
    if (slabs.spacing == Spacing::Even) return slabs.thickness;
    // Thickness is a convex function of depth; both ends may be fractions, so their neighbours count as well.
    double max = 0.0;
    for (const int i : {0, 1, slabs.count - 2, slabs.count - 1})
        if (i >= 0 && i < slabs.count) max = std::max(max, slabAt(slabs, i).thickness);
    return max;
}

}  // namespace

double brightestWithoutTerms(const Light& light, const SeenAir& air, const Slabs& slabs) {
    const double minAxis = std::max(air.axisNear, light.nearPlane);
    const double depth = air.farDepth - air.nearDepth;
    // Metres of ray per metre of depth, for the most slanted ray.
    const double slant = depth > 0.0 ? air.maxLength / depth : 1.0;
    const double slab = thickest(slabs) * slant;
    // A partly seen slab counts as a whole one.
    const double maxLength = air.maxLength + 2.0 * slab;
    return light.density / (4.0 * glm::pi<double>()) * greyOf(light) *
           maxAttenuationAlong(light, minAxis, maxLength, slab);
}

}  // namespace tyndall

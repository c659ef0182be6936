#include "needs/brightness.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "slice_constants.h"

namespace tyndall {
namespace {

double thickest(const Slabs& slabs) {
    if (slabs.count <= 0) return 0.0;
    if (slabs.spacing == Spacing::Even) return slabs.thickness;
    // Thickness is a convex function of depth; both ends may be fractions, so their neighbours count as well.
    double most = 0.0;
    for (const int i : {0, 1, slabs.count - 2, slabs.count - 1})
        if (i >= 0 && i < slabs.count) most = std::max(most, slabAt(slabs, i).thickness);
    return most;
}

}  // namespace

double brightestWithoutTerms(const Light& light, const SeenAir& air, const Slabs& slabs) {
    const double least = std::max(air.axisNear, light.nearPlane);
    const double depth = air.farDepth - air.nearDepth;
    // Metres of ray for a metre of depth, from the way the longest ray takes.
    const double slant = depth > 0.0 ? air.longest / depth : 1.0;
    const double slab = thickest(slabs) * slant;
    // A slab that is seen in part counts whole.
    const double longest = air.longest + 2.0 * slab;
    const double share = std::min(longest / (least * least), (4.0 + slab / least) / least);
    return light.density / (4.0 * glm::pi<double>()) * greyOf(light) *
           (light.intensity * share + light.ambient * longest);
}

}  // namespace tyndall

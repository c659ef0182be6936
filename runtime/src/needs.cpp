#include "needs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "convex_polyhedron.h"
#include "walls.h"

namespace tyndall {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

// Boxes come from floats, and surfaces may lie on their faces: metres, and share of the size.
constexpr double boxMargin = 1e-5, boxShare = 1e-6;

std::array<glm::dvec3, 8> cornersOf(const OccluderBox& box) {
    const glm::dvec3 margin = glm::dvec3(boxShare) * (box.maximum - box.minimum);
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = glm::dvec3((i & 1) ? box.maximum.x + margin.x : box.minimum.x - margin.x,
                                (i & 2) ? box.maximum.y + margin.y : box.minimum.y - margin.y,
                                (i & 4) ? box.maximum.z + margin.z : box.minimum.z - margin.z);
    return corners;
}

// Light-space half spaces of what the lamp shines through on its way to the air that is seen.
std::array<glm::dvec4, 6> wayTo(const Light& light, const SeenAir& air, std::uint32_t mapSize) {
    const glm::dvec2 reach = glm::tan(0.5 * light.fov);
    // A texel and a half: filtering reads the four nearest, a draw covers texels whose centres it covers.
    const glm::dvec2 texel = 3.0 * reach / static_cast<double>(mapSize);
    const glm::dvec2 least = glm::max(air.slideMin - texel, -reach), most = glm::min(air.slideMax + texel, reach);
    return {unitPlane({1.0, 0.0, least.x, 0.0}),          unitPlane({-1.0, 0.0, -most.x, 0.0}),
            unitPlane({0.0, 1.0, least.y, 0.0}),          unitPlane({0.0, -1.0, -most.y, 0.0}),
            glm::dvec4{0.0, 0.0, -1.0, -light.nearPlane}, glm::dvec4{0.0, 0.0, 1.0, air.axisFar}};
}

Shade shadeOf(const ConvexPolyhedron& solid, double margin, const glm::dvec2& texel) {
    Shade shade{unbounded, glm::dvec2(unbounded), glm::dvec2(-unbounded)};
    for (const glm::dvec3& p : solid.vertices) {
        shade.axis = std::min(shade.axis, -p.z - margin);
        shade.least = glm::min(shade.least, glm::dvec2(p) / -p.z);
        shade.most = glm::max(shade.most, glm::dvec2(p) / -p.z);
    }
    shade.least -= texel;
    shade.most += texel;
    return shade;
}

double area(const glm::dvec2& least, const glm::dvec2& most) {
    const glm::dvec2 extent = glm::max(most - least, glm::dvec2(0.0));
    return extent.x * extent.y;
}

// Share of what is seen of the slide above which an occluder's shade is not told from all of it.
constexpr double largeShare = 0.5;

ShadowNeed gather(std::span<const Shade> shades, const Light& light, const SeenAir& air) {
    ShadowNeed need{!shades.empty(), unbounded, unbounded, air.slideMax, air.slideMin};
    const double whole = largeShare * area(air.slideMin, air.slideMax);
    const auto within = [&](const Shade& shade) {
        return area(glm::max(shade.least, air.slideMin), glm::min(shade.most, air.slideMax));
    };
    for (const Shade& shade : shades) {
        need.firstOccluder = std::min(need.firstOccluder, shade.axis);
        if (within(shade) >= whole) need.firstLarge = std::min(need.firstLarge, shade.axis);
    }
    for (const Shade& shade : shades) {
        if (shade.axis >= need.firstLarge) continue;
        need.shadeMin = glm::min(need.shadeMin, shade.least);
        need.shadeMax = glm::max(need.shadeMax, shade.most);
    }
    if (area(glm::max(need.shadeMin, air.slideMin), glm::min(need.shadeMax, air.slideMax)) >= whole)
        need.firstLarge = need.firstOccluder;
    need.firstOccluder = std::max(need.firstOccluder, light.nearPlane);
    need.firstLarge = std::max(need.firstLarge, light.nearPlane);
    return need;
}

}  // namespace

OccluderBounds boundsOf(const OccluderBox& box) {
    OccluderBounds bounds{box, {}, 0.0};
    const glm::dvec3 middle = 0.5 * (box.minimum + box.maximum), half = 0.5 * (box.maximum - box.minimum);
    bounds.centre = glm::dvec3(box.worldFromBox * glm::dvec4(middle, 1.0));
    for (int corner = 0; corner < 4; ++corner) {  // opposite corners are as far
        const glm::dvec3 to((corner & 1) ? half.x : -half.x, (corner & 2) ? half.y : -half.y, half.z);
        bounds.radius = std::max(bounds.radius, glm::length(glm::dmat3(box.worldFromBox) * to));
    }
    bounds.radius = bounds.radius * (1.0 + 2.0 * boxShare) + boxMargin;
    return bounds;
}

ShadowNeed shadowNeed(const Light& light, const LightPose& pose, const SeenAir& air, std::span<const glm::dvec4> walls,
                      std::span<const OccluderBounds> occluders, std::uint32_t mapSize, std::vector<Shade>& scratch) {
    const std::array<glm::dvec4, 6> way = wayTo(light, air, mapSize);
    // Filtering reads the four nearest texels, a draw covers those whose centres it covers.
    const glm::dvec2 texel = 4.0 * glm::tan(0.5 * light.fov) / static_cast<double>(mapSize);
    const glm::dvec3 lamp(light.worldFromLight[3]);
    const glm::dmat3 lightFromWorld = glm::inverse(glm::dmat3(light.worldFromLight));
    InlineVector<glm::dvec4, mostWalls> lit;  // before the walls, in light space
    for (const glm::dvec4& wall : walls) lit.push_back(unitPlane(wall * pose.viewFromLight));

    scratch.clear();
    for (const OccluderBounds& occluder : occluders) {
        const glm::dvec3 centre = lightFromWorld * (occluder.centre - lamp);
        const auto beyond = [&](const glm::dvec4& plane) {
            return glm::dot(plane, glm::dvec4(centre, 1.0)) < -occluder.radius;
        };
        if (std::any_of(way.begin(), way.end(), beyond)) continue;

        std::array<glm::dvec3, 8> corners = cornersOf(occluder.box);
        double size = 0.0;
        for (glm::dvec3& corner : corners) {
            const glm::dvec3 fromLamp = glm::dvec3(occluder.box.worldFromBox * glm::dvec4(corner, 1.0)) - lamp;
            corner = lightFromWorld * fromLamp;
            size = std::max(size, glm::length(corner));
        }
        ConvexPolyhedron solid = hexahedron(corners);
        const double margin = boxMargin + boxShare * size;
        const auto cutOut = [&](glm::dvec4 plane, double by) {
            plane.w += by;
            return !cut(solid, plane, 0.0);
        };
        if (std::any_of(way.begin(), way.end(), [&](const glm::dvec4& plane) { return cutOut(plane, margin); }))
            continue;
        // A wall's plane lies a margin behind its triangles; what is less than that before them is the wall as well.
        if (std::any_of(lit.begin(), lit.end(),
                        [&](const glm::dvec4& plane) { return cutOut(plane, -2.0 * wallMargin(plane.w)); }))
            continue;
        scratch.push_back(shadeOf(solid, margin, texel));
    }
    return gather(scratch, light, air);
}

double FactorRange::largest() const {
    const glm::dvec3 magnitude = glm::max(glm::abs(least), glm::abs(most));
    return std::max({magnitude.x, magnitude.y, magnitude.z});
}

double FactorRange::spread() const {
    const glm::dvec3 half = 0.5 * (most - least);
    return std::max({half.x, half.y, half.z});
}

FactorRange cookieRange(const Light& light, const SeenAir& air, const TextureSurvey* survey) {
    if (!light.cookie) return {};
    if (!survey) return {glm::dvec3(0.0), glm::dvec3(unbounded)};
    const glm::dvec2 scale = 0.5 / glm::tan(0.5 * light.fov);
    // The slide's top is local +Y.
    const glm::dvec2 least(0.5 + air.slideMin.x * scale.x, 0.5 - air.slideMax.y * scale.y);
    const glm::dvec2 most(0.5 + air.slideMax.x * scale.x, 0.5 - air.slideMin.y * scale.y);
    const TextureRange range = rangeWithin(*survey, least, most);
    return {range.least, range.most};
}

FactorRange noiseRange(const Light& light, const TextureSurvey* survey) {
    if (!light.noise) return {};
    if (light.noise->gain == 0.0) return {glm::dvec3(0.0), glm::dvec3(0.0)};
    if (!survey) return {glm::dvec3(0.0), glm::dvec3(unbounded)};
    const glm::dvec3 least(survey->whole.least), most(survey->whole.most);
    // Values may be negative in a caller's float texture: the product's bounds are among these four.
    const double products[] = {least.r * least.g, least.r * most.g, most.r * least.g, most.r * most.g};
    const auto [low, high] = std::minmax_element(std::begin(products), std::end(products));
    return {glm::dvec3(light.noise->gain * *low), glm::dvec3(light.noise->gain * *high)};
}

}  // namespace tyndall

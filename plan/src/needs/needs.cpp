#include "needs/needs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/convex_polyhedron.h"
#include "visibility/walls.h"

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
constexpr std::size_t nearEnd = 4;  // of them: the one that begins it
std::array<glm::dvec4, 6> wayTo(const Light& light, const SeenAir& air, std::uint32_t mapSize) {
    const glm::dvec2 reach = glm::tan(0.5 * light.fov);
    // A texel and a half: filtering reads the four nearest, a draw covers texels whose centres it covers.
    const glm::dvec2 texel = 3.0 * reach / static_cast<double>(mapSize);
    const glm::dvec2 least = glm::max(air.slideMin - texel, -reach), most = glm::min(air.slideMax + texel, reach);
    return {unitPlane({1.0, 0.0, least.x, 0.0}),          unitPlane({-1.0, 0.0, -most.x, 0.0}),
            unitPlane({0.0, 1.0, least.y, 0.0}),          unitPlane({0.0, -1.0, -most.y, 0.0}),
            glm::dvec4{0.0, 0.0, -1.0, -light.nearPlane}, glm::dvec4{0.0, 0.0, 1.0, air.axisFar}};
}

const Shade emptyShade{unbounded, glm::dvec2(unbounded), glm::dvec2(-unbounded)};

template <class Points>
void widen(Shade& shade, const Points& points, double margin) {
    for (const glm::dvec3& p : points) {
        shade.axis = std::min(shade.axis, -p.z - margin);
        shade.least = glm::min(shade.least, glm::dvec2(p) / -p.z);
        shade.most = glm::max(shade.most, glm::dvec2(p) / -p.z);
    }
}

// Whether the triangle lies in the shade already: then so does whatever is cut from it, whose slopes are between its
// corners'.
bool within(const Shade& shade, const std::array<glm::dvec3, 3>& triangle, double margin) {
    return std::all_of(triangle.begin(), triangle.end(), [&](const glm::dvec3& p) {
        const double w = -p.z;
        return w > 0.0 && w - margin >= shade.axis && glm::all(glm::lessThanEqual(shade.least * w, glm::dvec2(p))) &&
               glm::all(glm::lessThanEqual(glm::dvec2(p), shade.most * w));
    });
}

Shade shadeOf(const ConvexPolyhedron& solid, double margin, const glm::dvec2& texel) {
    Shade shade = emptyShade;
    widen(shade, solid.vertices, margin);
    shade.least -= texel;
    shade.most += texel;
    return shade;
}

// What the half spaces leave of a triangle: each adds a corner at most.
using Corners = InlineVector<glm::dvec3, 3 + 6 + mostWalls>;

template <class Planes>
Corners clipped(const std::array<glm::dvec3, 3>& triangle, const Planes& planes) {
    Corners polygon;
    for (const glm::dvec3& corner : triangle) polygon.push_back(corner);
    for (const glm::dvec4& plane : planes) {
        Corners left;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec3 &here = polygon[i], &next = polygon[i + 1 < polygon.size() ? i + 1 : 0];
            const double inside = glm::dot(plane, glm::dvec4(here, 1.0)), then = glm::dot(plane, glm::dvec4(next, 1.0));
            if (inside >= 0.0) left.push_back(here);
            if ((inside > 0.0 && then < 0.0) || (inside < 0.0 && then > 0.0))
                left.push_back(glm::mix(here, next, inside / (inside - then)));
        }
        polygon = left;
    }
    return polygon;
}

double area(const glm::dvec2& least, const glm::dvec2& most) {
    const glm::dvec2 extent = glm::max(most - least, glm::dvec2(0.0));
    return extent.x * extent.y;
}

// Where to stop telling shade from light: the depth up to which the occluders' slopes together spare the most. What is
// seen at a distance from the lamp is about as wide as that distance.
ShadowNeed gather(std::span<Shade> shades, const Light& light, const SeenAir& air) {
    ShadowNeed need{!shades.empty(), unbounded, unbounded, air.slideMax, air.slideMin};
    if (shades.empty()) return need;
    std::sort(shades.begin(), shades.end(), [](const Shade& a, const Shade& b) { return a.axis < b.axis; });
    const double first = std::max(shades.front().axis, light.nearPlane);
    need.firstOccluder = need.firstLarge = first;
    const double whole = area(air.slideMin, air.slideMax);
    glm::dvec2 least = air.slideMax, most = air.slideMin;
    double spared = 0.0;
    for (std::size_t i = 0; i < shades.size(); ++i) {
        least = glm::min(least, glm::max(shades[i].least, air.slideMin));
        most = glm::max(most, glm::min(shades[i].most, air.slideMax));
        const double end = i + 1 < shades.size() ? std::clamp(shades[i + 1].axis, first, air.axisFar) : air.axisFar;
        const double gain = (1.0 - area(least, most) / whole) * (end * end - first * first);
        if (!(gain > spared)) continue;
        spared = gain;
        need.firstLarge = end;
        need.shadeMin = least;
        need.shadeMax = most;
    }
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
        InlineVector<glm::dvec4, 6 + mostWalls> planes;
        for (const glm::dvec4& plane : way) planes.push_back(plane + glm::dvec4(0.0, 0.0, 0.0, margin));
        // What is left has slopes: it stays before the lamp, however near to it the near plane is.
        planes[nearEnd].w = std::min(planes[nearEnd].w, -0.5 * light.nearPlane);
        // A wall's plane lies a margin behind its triangles; what is less than that before them is the wall as well.
        for (const glm::dvec4& plane : lit)
            planes.push_back(plane - glm::dvec4(0.0, 0.0, 0.0, 2.0 * wallMargin(plane.w)));
        if (std::any_of(planes.begin(), planes.end(), [&](const glm::dvec4& plane) { return !cut(solid, plane, 0.0); }))
            continue;
        Shade shade = shadeOf(solid, margin, texel);
        if (!occluder.box.triangles.empty()) {
            // The box is met; are its triangles?
            // Relative to the lamp first: far from the world's origin, its sums have lost their digits.
            const glm::dmat4& worldFromBox = occluder.box.worldFromBox;
            const glm::dmat3 turn = lightFromWorld * glm::dmat3(worldFromBox);
            const glm::dvec3 shift = lightFromWorld * (glm::dvec3(worldFromBox[3]) - lamp);
            shade = emptyShade;
            for (const std::array<glm::vec3, 3>& triangle : occluder.box.triangles) {
                std::array<glm::dvec3, 3> inLight;
                for (std::size_t i = 0; i < 3; ++i) inLight[i] = turn * glm::dvec3(triangle[i]) + shift;
                if (within(shade, inLight, margin)) continue;
                widen(shade, clipped(inLight, planes), margin);
            }
            if (!(shade.axis < unbounded)) continue;
            shade.least -= texel;
            shade.most += texel;
        }
        scratch.push_back(shade);
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

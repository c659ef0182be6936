#include "needs/needs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/convex_polyhedron.h"
#include "shape/light_shape.h"
#include "shape/shadow_projection.h"
#include "shape/slide.h"
#include "survey/box_margin.h"
#include "visibility/walls.h"

namespace tyndall {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

std::array<glm::dvec3, 8> cornersOf(const OccluderBox& box) {
    const glm::dvec3 margin = glm::dvec3(boxShare) * (box.maximum - box.minimum);
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = glm::dvec3((i & 1) ? box.maximum.x + margin.x : box.minimum.x - margin.x,
                                (i & 2) ? box.maximum.y + margin.y : box.minimum.y - margin.y,
                                (i & 4) ? box.maximum.z + margin.z : box.minimum.z - margin.z);
    return corners;
}

// Light-space planes, unit normals, of the space between the lamp and the air that is seen.
FrustumPlanes shadowFrustum(const LightShape& shape, const SeenAir& air, std::uint32_t mapSize) {
    // Filtering reads the four nearest texels, and a draw covers the texels whose centres it covers.
    const SlopeRange read = widened(air.slopes, texelSlopes(shape, mapSize, 1.5));
    return changed(frustumPlanes(shape, intersection(read, slopesOf(shape)), shape.nearPlane, air.axisFar), unitPlane);
}

OccluderShadow noShadow() {
    return {unbounded, SlopeRange::none()};
}

template <class Points>
void widen(OccluderShadow& shadow, const LightShape& shape, const Points& points, double margin) {
    for (const glm::dvec3& p : points) {
        shadow.axis = std::min(shadow.axis, axisOf(p) - margin);
        add(shadow.slopes, slopeOf(shape, p));
    }
}

// Whether the shadow already holds the triangle. It then holds every part of it, too: the slopes of a part lie between
// those of the corners.
bool holds(const OccluderShadow& shadow, const LightShape& shape, const std::array<glm::dvec3, 3>& triangle,
           double margin) {
    return std::all_of(triangle.begin(), triangle.end(), [&](const glm::dvec3& p) {
        return axisOf(p) - margin >= shadow.axis && holds(shape, shadow.slopes, p);
    });
}

OccluderShadow shadowOf(const ConvexPolyhedron& solid, const LightShape& shape, double margin,
                        const glm::dvec2& texels) {
    OccluderShadow shadow = noShadow();
    widen(shadow, shape, solid.vertices, margin);
    shadow.slopes = widened(shadow.slopes, texels);
    return shadow;
}

// The part of a triangle that lies in all half spaces. Each adds at most one corner; the capacity is doubled for
// corners that rounding repeats.
constexpr std::size_t maxHalfSpaces = 6 + maxWalls;
using Corners = InlineVector<glm::dvec3, 2 * (3 + maxHalfSpaces)>;

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

// Chooses `firstLarge`: the distance up to which the occluders' slopes together save the most air. The seen air is
// about as wide as its distance from the lamp.
ShadowNeed gather(std::span<OccluderShadow> shadows, const Light& light, const SeenAir& air) {
    ShadowNeed need{!shadows.empty(), unbounded, unbounded, {air.slopes.max, air.slopes.min}};
    if (shadows.empty()) return need;
    std::sort(shadows.begin(), shadows.end(),
              [](const OccluderShadow& a, const OccluderShadow& b) { return a.axis < b.axis; });
    const double first = std::max(shadows.front().axis, light.nearPlane);
    need.firstOccluder = need.firstLarge = first;
    const double whole = area(air.slopes);
    SlopeRange shaded{air.slopes.max, air.slopes.min};  // empty
    double spared = 0.0;
    for (std::size_t i = 0; i < shadows.size(); ++i) {
        const SlopeRange seen = intersection(shadows[i].slopes, air.slopes);
        shaded = {glm::min(shaded.min, seen.min), glm::max(shaded.max, seen.max)};
        const double end = i + 1 < shadows.size() ? std::clamp(shadows[i + 1].axis, first, air.axisFar) : air.axisFar;
        const double gain = (1.0 - area(shaded) / whole) * (end * end - first * first);
        if (!(gain > spared)) continue;
        spared = gain;
        need.firstLarge = end;
        need.slopes = shaded;
    }
    return need;
}

}  // namespace

ShadowNeed shadowNeed(const Light& light, const LightPose& pose, const SeenAir& air, std::span<const glm::dvec4> walls,
                      const OccluderSet& occluders, std::uint32_t mapSize, std::vector<OccluderShadow>& scratch) {
    const LightShape shape = shapeOf(light);
    const FrustumPlanes frustum = shadowFrustum(shape, air, mapSize);
    const std::array<glm::dvec4, 6> frustumSides = frustum.all();
    // Filtering reads the four nearest texels, and a draw covers the texels whose centres it covers.
    const glm::dvec2 texels = texelSlopes(shape, mapSize, 2.0);
    const glm::dvec3 lamp(light.worldFromLight[3]);
    const glm::dmat3 lightFromWorld = glm::inverse(glm::dmat3(light.worldFromLight));
    InlineVector<glm::dvec4, maxWalls> lit;  // before the walls, in light space
    for (const glm::dvec4& wall : walls) lit.push_back(unitPlane(wall * pose.viewFromLight));

    scratch.clear();
    const std::span<const BoundingSphere> spheres = occluders.spheres();
    for (std::size_t index = 0; index < spheres.size(); ++index) {
        const BoundingSphere& sphere = spheres[index];
        const glm::dvec3 centre = lightFromWorld * (sphere.centre - lamp);
        const auto beyond = [&](const glm::dvec4& plane) {
            return glm::dot(plane, glm::dvec4(centre, 1.0)) < -sphere.radius;
        };
        if (std::any_of(frustumSides.begin(), frustumSides.end(), beyond)) continue;

        const OccluderBox box = occluders.box(index);
        std::array<glm::dvec3, 8> corners = cornersOf(box);
        double size = 0.0;
        for (glm::dvec3& corner : corners) {
            const glm::dvec3 fromLamp = glm::dvec3(box.worldFromBox * glm::dvec4(corner, 1.0)) - lamp;
            corner = lightFromWorld * fromLamp;
            size = std::max(size, glm::length(corner));
        }
        ConvexPolyhedron solid = hexahedron(corners);
        const double margin = boxMargin + boxShare * size;
        FrustumPlanes withMargin =
            changed(frustum, [&](const glm::dvec4& plane) { return plane + glm::dvec4(0.0, 0.0, 0.0, margin); });
        // The rest must have slopes, so it must stay before the lamp, even if the near plane is very near to the lamp.
        withMargin.near.w = std::min(withMargin.near.w, -0.5 * light.nearPlane);
        InlineVector<glm::dvec4, maxHalfSpaces> planes;
        for (const glm::dvec4& plane : withMargin.all()) planes.push_back(plane);
        // A wall's plane lies a margin behind its triangles. Occluders within a margin before them belong to the wall.
        for (const glm::dvec4& plane : lit)
            planes.push_back(plane - glm::dvec4(0.0, 0.0, 0.0, 2.0 * wallMargin(plane.w)));
        if (std::any_of(planes.begin(), planes.end(), [&](const glm::dvec4& plane) { return !cut(solid, plane, 0.0); }))
            continue;
        OccluderShadow shadow = shadowOf(solid, shape, margin, texels);
        if (!box.triangles.empty()) {
            // The frustum meets the box: does it meet the triangles?
            // Positions relative to the lamp: far from the world's origin, world coordinates lose precision.
            const glm::dmat4& worldFromBox = box.worldFromBox;
            const glm::dmat3 turn = lightFromWorld * glm::dmat3(worldFromBox);
            const glm::dvec3 shift = lightFromWorld * (glm::dvec3(worldFromBox[3]) - lamp);
            shadow = noShadow();
            for (const std::array<glm::vec3, 3>& triangle : box.triangles) {
                std::array<glm::dvec3, 3> inLight;
                for (std::size_t i = 0; i < 3; ++i) inLight[i] = turn * glm::dvec3(triangle[i]) + shift;
                if (holds(shadow, shape, inLight, margin)) continue;
                widen(shadow, shape, clipped(inLight, planes), margin);
            }
            if (!(shadow.axis < unbounded)) continue;
            shadow.slopes = widened(shadow.slopes, texels);
        }
        scratch.push_back(shadow);
    }
    return gather(scratch, light, air);
}

double FactorRange::largest() const {
    const glm::dvec3 magnitude = glm::max(glm::abs(min), glm::abs(max));
    return std::max({magnitude.x, magnitude.y, magnitude.z});
}

double FactorRange::spread() const {
    const glm::dvec3 half = 0.5 * (max - min);
    return std::max({half.x, half.y, half.z});
}

FactorRange cookieRange(const Light& light, const SeenAir& air, const TextureSurvey* survey) {
    if (!light.cookie) return {};
    if (!survey) return {glm::dvec3(0.0), glm::dvec3(unbounded)};
    const SlideRange slide = slideFromSlopes(shapeOf(light), air.slopes);
    const TextureRange range = rangeWithin(*survey, slide.min, slide.max);
    return {range.min, range.max};
}

FactorRange noiseRange(const Light& light, const TextureSurvey* survey) {
    if (!light.noise) return {};
    if (light.noise->gain == 0.0) return {glm::dvec3(0.0), glm::dvec3(0.0)};
    if (!survey) return {glm::dvec3(0.0), glm::dvec3(unbounded)};
    const glm::dvec3 min(survey->whole.min), max(survey->whole.max);
    // Values may be negative in a caller's float texture: the product's bounds are among these four.
    const double products[] = {min.r * min.g, min.r * max.g, max.r * min.g, max.r * max.g};
    const auto [low, high] = std::minmax_element(std::begin(products), std::end(products));
    return {glm::dvec3(light.noise->gain * *low), glm::dvec3(light.noise->gain * *high)};
}

}  // namespace tyndall

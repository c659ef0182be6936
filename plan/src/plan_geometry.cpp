#include "plan_geometry.h"

#include <cmath>

#include "geometry/slice_polygon.h"
#include "shape/light_shape.h"

namespace tyndall {
namespace {

std::uint32_t channelMask(Accumulation accumulation, int slab) {
    if (accumulation != Accumulation::Rgba8Routed) return 0xffffffffu;
    return 0xffu << (8 * (slab & 3));  // right for negative numbers, too: they are two's complements
}

// A convex polygon of the last `corners` vertices, as a fan.
void appendFan(std::vector<std::uint32_t>& indices, std::size_t vertices, std::size_t corners) {
    const auto first = static_cast<std::uint32_t>(vertices - corners);
    for (std::uint32_t i = 2; i < corners; ++i) {
        indices.push_back(first);
        indices.push_back(first + i - 1);
        indices.push_back(first + i);
    }
}

void appendPolygon(Plan& plan, std::vector<std::uint32_t>& indices, const SlicePolygon& polygon, const Slab& slab) {
    const std::uint32_t mask = channelMask(plan.accumulation, slab.number);
    for (std::size_t corner = 0; corner < polygon.count; ++corner)
        plan.vertices.push_back(
            {glm::vec3(glm::dvec3(polygon.corners[corner], -slab.middle)), static_cast<float>(slab.thickness), mask});
    appendFan(indices, plan.vertices.size(), polygon.count);
}

struct Range {
    int first, end;
};

// The slabs whose slices lie within the seen depths.
Range seenSlabs(const Slabs& slabs, const SeenAir& air, bool everything) {
    if (everything) return {0, slabs.count};
    const double margin = 1e-9 * air.farDepth;
    Range range{0, slabs.count};
    while (range.first < range.end && slabAt(slabs, range.first).middle > air.farDepth + margin) ++range.first;
    while (range.end > range.first && slabAt(slabs, range.end - 1).middle < air.nearDepth - margin) --range.end;
    return range;
}

// A plane of view space across the light's axis.
glm::dvec4 acrossAxis(const LightPose& pose, double axis, Keep keep) {
    return unitPlane(axisPlane(axis, keep) * pose.lightFromView);
}

// Planes that bound every slice.
using SlicePlanes = InlineVector<glm::dvec4, 6 + maxClipPlanes + 4>;

SlicePlanes slicePlanes(const LightVolume& volume) {
    SlicePlanes planes;
    for (const glm::dvec4& plane : boundingPlanes(volume)) planes.push_back(plane);
    for (const glm::dvec4& plane : volume.guard) planes.push_back(plane);
    return planes;
}

// Planes that divide slices into the part that is lit and seen (positive) and the rest: the walls, the sides of the
// cookie's beam, and the ends of the seen air along the axis if that saves a tenth of the volume or more.
using Cuts = InlineVector<glm::dvec4, maxWalls + 8 + 2>;

Cuts unseenBeyond(const Light& light, const Candidate& candidate) {
    Cuts cuts;
    const LightVolume& volume = candidate.seen.volume;
    for (const glm::dvec4& wall : volume.walls) cuts.push_back(wall);
    for (const glm::dvec4& side : volume.beam) cuts.push_back(side);
    const SeenAir& air = candidate.seen.air;
    if (!air.any) return cuts;
    const double length = volume.axisFar - volume.axisNear;
    const double margin = 1e-6 * light.farPlane;
    if (air.axisNear - volume.axisNear > 0.1 * length)
        cuts.push_back(acrossAxis(candidate.seen.pose, air.axisNear - margin, Keep::Above));
    if (volume.axisFar - air.axisFar > 0.1 * length)
        cuts.push_back(acrossAxis(candidate.seen.pose, air.axisFar + margin, Keep::Below));
    return cuts;
}

// Where a light's slices are cut apart, and which pieces need the shadow map.
struct Partition {
    InlineVector<glm::dvec4, 6> cuts;  ///< planes of view space
    LightShape shape;
    const LightPose* pose = nullptr;
    double first = 0.0, large = 0.0;  ///< metres along the light's axis
    SlopeRange shaded;                ///< between both

    // A piece lies on one side of every cut, so any of its points represents the whole piece.
    bool mayBeShaded(const SlicePolygon& piece, double depth) const {
        glm::dvec2 middle(0.0);
        for (std::size_t i = 0; i < piece.count; ++i) middle += piece.corners[i];
        const glm::dvec3 p(pose->lightFromView * glm::dvec4(middle / static_cast<double>(piece.count), -depth, 1.0));
        if (axisOf(p) < first) return false;
        const glm::dvec2 slope = slopeOf(shape, p);
        return axisOf(p) >= large ||
               (glm::all(glm::greaterThan(slope, shaded.min)) && glm::all(glm::lessThan(slope, shaded.max)));
    }
};

// The shadow map passes all light before the first occluder; its depths are rounded by less than this share.
constexpr double mapRounding = 1e-4;
// A part with a smaller share of the light's length costs more to draw separately than it saves.
constexpr double minPart = 0.05;

Partition partition(const Light& light, const Candidate& candidate) {
    Partition parts;
    if (!candidate.needed.divisible) return parts;
    const SeenAir& air = candidate.seen.air;
    const ShadowNeed& need = candidate.needed.shadow;
    const double minLength = minPart * (air.axisFar - air.axisNear);
    parts.shape = shapeOf(light);
    parts.pose = &candidate.seen.pose;
    parts.first = need.firstOccluder * (1.0 - mapRounding);
    parts.large = need.firstLarge * (1.0 - mapRounding);
    parts.shaded = need.slopes;
    if (parts.first - air.axisNear > minLength)
        parts.cuts.push_back(acrossAxis(candidate.seen.pose, parts.first, Keep::Below));
    if (std::min(parts.large, air.axisFar) - std::max(parts.first, air.axisNear) > minLength) {
        if (parts.large < air.axisFar) parts.cuts.push_back(acrossAxis(candidate.seen.pose, parts.large, Keep::Below));
        for (int axis = 0; axis < 2; ++axis) {
            // Slices extend beyond the seen air. A shadow at the edge of that air is assumed to continue beyond it.
            if (parts.shaded.min[axis] <= air.slopes.min[axis]) parts.shaded.min[axis] = -HUGE_VAL;
            if (parts.shaded.max[axis] >= air.slopes.max[axis]) parts.shaded.max[axis] = HUGE_VAL;
            for (const Keep keep : {Keep::Above, Keep::Below}) {
                const double slope = keep == Keep::Above ? parts.shaded.min[axis] : parts.shaded.max[axis];
                if (std::isinf(slope)) continue;
                parts.cuts.push_back(
                    unitPlane(slopePlane(parts.shape, axis, slope, keep) * candidate.seen.pose.lightFromView));
            }
        }
    } else {
        parts.large = parts.first;
    }
    return parts;
}

// Six lines divide the plane into at most 1 + 6 + 15 = 22 pieces.
using Pieces = InlineVector<SlicePolygon, 24>;

// Every cut goes through all pieces, so that neighbours share all corners: the rasterizer would round a divided side
// and an undivided one differently.
Pieces cutApart(const SlicePolygon& whole, const Partition& parts, double depth) {
    Pieces pieces;
    if (whole.count > 0) pieces.push_back(whole);
    for (const glm::dvec4& plane : parts.cuts) {
        const std::size_t before = pieces.size();
        for (std::size_t i = 0; i < before; ++i) {
            SlicePolygon inside, outside;
            split(pieces[i], glm::dvec2(plane), plane.w - plane.z * depth, inside, outside);
            if (inside.count == 0 || outside.count == 0) continue;
            pieces[i] = inside;
            pieces.push_back(outside);
        }
    }
    return pieces;
}

// Has all terms of the light, and the constants that were appended last.
PlannedPart partOf(const Plan& plan, const PlannedLight& light) {
    PlannedPart part;
    part.light = static_cast<std::uint32_t>(light.light);
    part.constants = static_cast<std::uint32_t>(plan.constants.size() - 1);
    part.terms = light.terms;
    return part;
}

// All indices from `firstIndex` on.
void appendPart(Plan& plan, const PlannedLight& light, std::uint32_t firstIndex, int slices, bool shadow) {
    PlannedPart part = partOf(plan, light);
    if (!shadow) part.terms = part.terms.without(Term::Shadow);
    part.firstIndex = firstIndex;
    part.indexCount = static_cast<std::uint32_t>(plan.indices.size()) - firstIndex;
    part.slices = slices;
    if (part.indexCount > 0) plan.parts.push_back(part);
}

// The air behind a wall lies in its umbra. The bias keeps the wall's shadow off the air before the wall. Behind the
// wall it would let light through, so it is reversed there.
void appendUmbra(Plan& plan, const PlannedLight& light, const std::vector<std::uint32_t>& indices, int slices) {
    if (indices.empty()) return;
    SliceConstants constants = plan.constants.back();
    constants.shadow.w = -constants.shadow.w;
    plan.constants.push_back(constants);
    const auto first = static_cast<std::uint32_t>(plan.indices.size());
    plan.indices.insert(plan.indices.end(), indices.begin(), indices.end());
    appendPart(plan, light, first, slices, true);
}

}  // namespace

// PlanOptions::everything divides slices in the same way and draws all pieces. So pieces that are drawn with and
// without it have the same corners, and cover the same pixels.
void appendPolygons(Plan& plan, PlannedLight& light, const Light& source, const Candidate& candidate,
                    const PlanOptions& options, std::vector<std::uint32_t>& scratch) {
    const LightVolume& volume = candidate.seen.volume;
    const SlicePlanes planes = slicePlanes(volume);
    const Cuts cuts = unseenBeyond(source, candidate);
    const Partition parts = partition(source, candidate);
    const bool apart = !parts.cuts.empty() && !options.everything;
    // The rectangle is larger than the bounds, so that every side of a slice comes from a plane.
    const glm::dvec2 margin = 1e-3 * (volume.boundsMax - volume.boundsMin);
    const glm::dvec2 rectangleMin = volume.boundsMin - margin;
    const glm::dvec2 rectangleMax = volume.boundsMax + margin;
    const Range range = seenSlabs(candidate.slabs, candidate.seen.air, options.everything);

    light.firstIndex = static_cast<std::uint32_t>(plan.indices.size());
    scratch.clear();
    int before = 0, behind = 0, inUmbra = 0;
    for (int i = range.first; i < range.end; ++i) {
        const Slab slab = slabAt(candidate.slabs, i);
        SlicePolygon polygon = slicePolygon(rectangleMin, rectangleMax, planes, slab.middle);
        SlicePolygon inside, outside;
        bool umbra = false;
        for (std::size_t k = 0; k < cuts.size(); ++k) {  // the walls come first
            const glm::dvec4& cut = cuts[k];
            split(polygon, glm::dvec2(cut), cut.w - cut.z * slab.middle, inside, outside);
            if (options.everything)
                appendPolygon(plan, k < volume.walls.size() ? scratch : plan.indices, outside, slab);
            umbra |= k < volume.walls.size() && outside.count > 0;
            polygon = inside;
        }
        inUmbra += umbra;
        bool lit = false, shaded = false;
        for (const SlicePolygon& piece : cutApart(polygon, parts, slab.middle)) {
            const bool mayBeShaded = apart && parts.mayBeShaded(piece, slab.middle);
            appendPolygon(plan, mayBeShaded ? scratch : plan.indices, piece, slab);
            (mayBeShaded ? shaded : lit) = true;
        }
        before += lit;
        behind += shaded;
    }
    light.slices = range.end - range.first;
    light.divided = apart && before > 0;
    if (apart) {
        appendPart(plan, light, light.firstIndex, before, false);
        const auto second = static_cast<std::uint32_t>(plan.indices.size());
        plan.indices.insert(plan.indices.end(), scratch.begin(), scratch.end());
        appendPart(plan, light, second, behind, true);
    } else {
        appendPart(plan, light, light.firstIndex, light.slices, true);
        appendUmbra(plan, light, scratch, inUmbra);
    }
    light.indexCount = static_cast<std::uint32_t>(plan.indices.size()) - light.firstIndex;
}

void appendOutlined(Plan& plan, PlannedLight& light, std::span<const glm::dvec2> corners) {
    light.firstIndex = static_cast<std::uint32_t>(plan.indices.size());
    for (const glm::dvec2& corner : corners)
        plan.vertices.push_back({glm::vec3(glm::dvec3(corner, 0.0)), 0.0f, 0xffffffffu});
    appendFan(plan.indices, plan.vertices.size(), corners.size());
    light.indexCount = static_cast<std::uint32_t>(plan.indices.size()) - light.firstIndex;
    PlannedPart part;
    part.method = Method::Raycast;
    part.light = static_cast<std::uint32_t>(light.light);
    part.constants = static_cast<std::uint32_t>(plan.raycasts.size() - 1);
    part.terms = light.terms;
    part.firstIndex = light.firstIndex;
    part.indexCount = light.indexCount;
    if (part.indexCount > 0) plan.parts.push_back(part);
}

void appendQuads(Plan& plan, PlannedLight& light, const Candidate& candidate, const PlanOptions& options) {
    const Slabs& slabs = candidate.slabs;
    const Range range = seenSlabs(slabs, candidate.seen.air, options.everything);
    const bool shared = slabs.spacing == Spacing::Even;
    const int first = shared ? 0 : range.first;
    std::uint32_t start = shared ? 0 : static_cast<std::uint32_t>(plan.indices.size());
    if (!shared || plan.vertices.empty())
        for (int i = first; i < (shared ? slabs.count : range.end); ++i) {
            const Slab slab = slabAt(slabs, i);
            const double extent = slabs.farDepth - slabs.nearDepth;
            const double depth = shared ? (i + 0.5) / slabs.count : (slabs.farDepth - slab.middle) / extent;
            const double thickness = shared ? 1.0 / slabs.count : slab.thickness / extent;
            for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
                plan.vertices.push_back({glm::vec3(corner, static_cast<float>(depth)), static_cast<float>(thickness),
                                         channelMask(plan.accumulation, slab.number)});
            appendFan(plan.indices, plan.vertices.size(), 4);
        }
    constexpr std::uint32_t perQuad = 6;
    start += perQuad * static_cast<std::uint32_t>(range.first - first);
    light.slices = range.end - range.first;
    light.firstIndex = start;
    light.indexCount = perQuad * static_cast<std::uint32_t>(light.slices);
    PlannedPart part = partOf(plan, light);
    part.firstIndex = light.firstIndex;
    part.indexCount = light.indexCount;
    part.slices = light.slices;
    if (part.indexCount > 0) plan.parts.push_back(part);
}

}  // namespace tyndall

#include "plan_geometry.h"

#include "slice_polygon.h"

namespace tyndall {
namespace {

std::uint32_t channelMask(Accumulation accumulation, int slice) {
    if (accumulation != Accumulation::Rgba8Routed) return 0xffffffffu;
    return 0xffu << (8 * (slice % 4));
}

// A convex polygon of the last `corners` vertices, as a fan.
void appendFan(Plan& plan, std::size_t corners) {
    const auto first = static_cast<std::uint32_t>(plan.vertices.size() - corners);
    for (std::uint32_t i = 2; i < corners; ++i) {
        plan.indices.push_back(first);
        plan.indices.push_back(first + i - 1);
        plan.indices.push_back(first + i);
    }
}

}  // namespace

void appendPolygons(Plan& plan, PlannedLight& light, const LightVolume& volume) {
    std::vector<glm::dvec4> planes = volume.planes;
    planes.insert(planes.end(), volume.guard.begin(), volume.guard.end());
    // Larger than the bounds, so that every side of a slice comes from a plane and none from the bounds.
    const glm::dvec2 margin = 1e-3 * (volume.boundsMax - volume.boundsMin);
    const glm::dvec2 rectangleMin = volume.boundsMin - margin;
    const glm::dvec2 rectangleMax = volume.boundsMax + margin;
    const double thickness = (volume.farDepth - volume.nearDepth) / light.slices;

    light.firstIndex = static_cast<std::uint32_t>(plan.indices.size());
    for (int i = 0; i < light.slices; ++i) {
        const double depth = volume.farDepth - (i + 0.5) * thickness;
        const SlicePolygon polygon = slicePolygon(rectangleMin, rectangleMax, planes, depth);
        const std::uint32_t mask = channelMask(plan.accumulation, i);
        for (std::size_t corner = 0; corner < polygon.count; ++corner)
            plan.vertices.push_back(
                {glm::vec3(glm::dvec3(polygon.corners[corner], -depth)), static_cast<float>(thickness), mask});
        appendFan(plan, polygon.count);
    }
    light.indexCount = static_cast<std::uint32_t>(plan.indices.size()) - light.firstIndex;
}

void appendQuads(Plan& plan, PlannedLight& light) {
    if (plan.vertices.empty()) {
        const double thickness = 1.0 / light.slices;
        for (int i = 0; i < light.slices; ++i) {
            const auto depth = static_cast<float>((i + 0.5) * thickness);
            for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
                plan.vertices.push_back(
                    {glm::vec3(corner, depth), static_cast<float>(thickness), channelMask(plan.accumulation, i)});
            appendFan(plan, 4);
        }
    }
    light.firstIndex = 0;
    light.indexCount = static_cast<std::uint32_t>(plan.indices.size());
}

}  // namespace tyndall

#include "raycast/raycast_constants.h"

#include <tyndall/article.h>

#include <algorithm>
#include <bit>

#include "raycast/view_rays.h"
#include "shape/light_shape.h"

namespace tyndall {
namespace {

// Depths end here where nothing else ends them; floats still square it.
constexpr double farthest = 1e18;

// The published weights belong to equal slices over the depth of the volume: 9/f each. Their sum is the integral over
// that depth.
glm::vec4 weightConstants(const PlanOptions& options, const Slabs& slabs) {
    if (options.look == Look::Article)
        return glm::dvec4(article::weight / (slabs.farDepth - slabs.nearDepth), 0.0, 0.0, 0.0);
    return {1.0f, 1.0f, 0.0f, 0.0f};
}

}  // namespace

RaycastConstants raycastConstants(const SliceConstants& slice, const Light& light, const View& view,
                                  const PlanOptions& options, const LightPose& pose, const LightVolume& volume,
                                  const Slabs& slabs) {
    RaycastConstants constants{};
    const ViewRays rays = viewRays(view, pose);
    const double lampDepth = std::clamp(-pose.viewFromLight[3].z, 0.0, std::min(view.farPlane, farthest));
    for (std::size_t i = 0; i < rays.origin.size(); ++i) {
        const glm::dvec4 atLamp = rays.origin[i] + lampDepth * rays.direction[i];
        constants.origin[i] = glm::dvec4(glm::dvec3(atLamp), rays.origin[i].w);
        constants.direction[i] = rays.direction[i];
    }
    constants.pixel = glm::dvec4(0.0, 0.0, lampDepth, 0.0);
    std::size_t planes = 0;
    static_assert(std::size(RaycastConstants{}.planes) == maxClipPlanes + maxWalls + 8);
    const auto add = [&](const glm::dvec4& plane) { constants.planes[planes++] = plane * pose.viewFromLight; };
    for (const glm::dvec4& plane : volume.clipPlanes) add(plane);
    for (const glm::dvec4& wall : volume.walls) add(wall);
    for (const glm::dvec4& side : volume.beam) add(side);

    const LightShape shape = shapeOf(light);
    constants.volume = glm::dvec4(shape.tanHalfFov, shape.nearPlane, shape.farPlane);
    const double end = std::min({view.farPlane, view.sceneDepth, farthest});
    constants.depths = glm::dvec4(view.nearPlane, end, planes, std::bit_ceil(options.shadowMapSize));
    constants.surface = glm::dvec4(rays.scale, 0.0, 0.0);
    constants.cookieScale = slice.cookieScale;
    constants.attenuation = slice.attenuation;
    constants.dust = slice.dust;
    constants.noise1 = slice.noise1;
    constants.noise2 = slice.noise2;
    constants.colour = slice.colour;
    constants.weight = weightConstants(options, slabs);
    constants.shadow = slice.shadow;
    constants.scattering = slice.scattering;
    constants.channels = glm::vec4(options.accumulation == Accumulation::Rgba8Routed ? 0.25f : 1.0f);
    return constants;
}

std::uint32_t shadowHierarchySide(std::uint32_t size) {
    return std::max(1u, std::bit_ceil(size) / 2);
}

std::uint32_t shadowHierarchyLevels(std::uint32_t size) {
    return static_cast<std::uint32_t>(std::bit_width(shadowHierarchySide(size)));
}

}  // namespace tyndall

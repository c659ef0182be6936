#include <cfloat>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "check/plan_check.h"

namespace tyndall {
namespace {

// A pyramid of 179 degrees is 115 times as wide as it is long; one of a hundredth of a degree is a thread
// of 2 mm at 10 m, the limit of what the shader's floats resolve from a few hundred metres away.
constexpr double minFov = 0.01 * glm::pi<double>() / 180.0;
constexpr double maxFov = 179.0 * glm::pi<double>() / 180.0;
constexpr std::string_view fovRule = "from 0.01 to 179 degrees (0.000174533 to 3.12413936 rad)";
constexpr std::string_view fovRemedy = "give the full angle in radians, or split the light in two";

Result<void> checkNoise(const CheckedObject& place, const Noise& noise) {
    const auto finite = [](std::string_view field, double value) {
        return Bound{field, value, -DBL_MAX, DBL_MAX, "finite", "check what it was computed from"};
    };
    const Bound bounds[] = {
        finite("noise.scale.x", noise.scale.x),
        finite("noise.scale.y", noise.scale.y),
        finite("noise.scroll1.x", noise.scroll1.x),
        finite("noise.scroll1.y", noise.scroll1.y),
        finite("noise.scroll2.x", noise.scroll2.x),
        finite("noise.scroll2.y", noise.scroll2.y),
        {"noise.gain", noise.gain, 0.0, DBL_MAX, "0 or more and finite", "1/0.3 suits noise of mean product 0.3"},
    };
    return checkBounds(place, bounds);
}

Result<void> checkClipPlanes(const CheckedObject& where, const Light& light, const PlanOptions& options) {
    const std::size_t count = light.clipPlanes.size();
    if (count > 6)
        return broken(where.text() + ": clipPlanes has " + std::to_string(count) +
                      " planes: it must have at most 6; remove those that cut nothing");
    if (options.geometry == Geometry::StretchedQuads && count > 2)
        return broken(where.text() + ": clipPlanes has " + std::to_string(count) +
                      " planes: it must have at most 2 with stretched quads, whose eight clip distances hold the six "
                      "planes of the pyramid; take exact polygons, which hold 6");
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec4& plane = light.clipPlanes[i];
        const double length = glm::length(glm::dvec3(plane));
        const auto written = [&] {
            return where.text() + ": clipPlanes[" + std::to_string(i) + "] is (" + text(plane.x) + ", " +
                   text(plane.y) + ", " + text(plane.z) + ", " + text(plane.w) + ")";
        };
        if (!(std::isfinite(length) && std::isfinite(plane.w)))
            return broken(
                written() +
                ": all four numbers and the normal's length must be finite; check what they were computed from");
        if (!(length >= 1e-6))
            return broken(written() + ", whose normal has the length " + text(length) +
                          ": it must be 1e-6 or more; give a unit normal");
    }
    return {};
}

}  // namespace

std::string placeOf(const Light& light, std::size_t index) {
    const std::string number = "light " + std::to_string(index);
    return light.name.empty() ? number : number + " \"" + light.name + "\"";
}

Result<void> checkLight(const Light& light, std::size_t index, const PlanOptions& options) {
    const CheckedObject place{{}, &light, index};
    if (const Result<void> checked = checkRigid(place, "worldFromLight", light.worldFromLight); !checked)
        return checked;
    const auto strength = [](std::string_view field, double value) {
        return Bound{field, value, 0.0, DBL_MAX, "0 or more and finite", "give 0 to leave it out"};
    };
    const Bound bounds[] = {
        {"fov.x", light.fov.x, minFov, maxFov, fovRule, fovRemedy},
        {"fov.y", light.fov.y, minFov, maxFov, fovRule, fovRemedy},
        {"nearPlane", light.nearPlane, 1e-6, farthest, "from 1e-6 to 1e9 m", "0.05 is a good start"},
        {"farPlane", light.farPlane, 1e-6, farthest, "from 1e-6 to 1e9 m", "give how far the light reaches"},
        strength("colour.r", light.colour.r),
        strength("colour.g", light.colour.g),
        strength("colour.b", light.colour.b),
        strength("intensity", light.intensity),
        strength("density", light.density),
        strength("ambient", light.ambient),
    };
    if (const Result<void> checked = checkBounds(place, bounds); !checked) return checked;
    if (!(light.farPlane > light.nearPlane))
        return broken(place.text() + ": farPlane is " + text(light.farPlane) + ": it must be beyond nearPlane, " +
                      text(light.nearPlane) + "; raise farPlane or lower nearPlane");
    if (!(std::abs(light.anisotropy) < 1.0))
        return broken(place.text() + ": anisotropy is " + text(light.anisotropy) +
                      ": it must lie between -1 and 1, both excluded; 0 scatters evenly, 0.6 suits mist");
    if (light.albedo && !(*light.albedo > 0.0 && *light.albedo <= 1.0))
        return broken(place.text() + ": albedo is " + text(*light.albedo) +
                      ": it must be over 0 and at most 1; leave it out for air without extinction");
    if (light.noise)
        if (const Result<void> checked = checkNoise(place, *light.noise); !checked) return checked;
    return checkClipPlanes(place, light, options);
}

}  // namespace tyndall

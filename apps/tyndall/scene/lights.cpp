#include "lights.h"

#include <cmath>
#include <numbers>

#include "light_extras.h"
#include "pose.h"

namespace tyndall::app {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

const nlohmann::json* tyndallExtras(const Document& document, std::size_t node) {
    const nlohmann::json& source = document.json["nodes"][node];
    const auto extras = source.find("extras");
    if (extras == source.end() || !extras->is_object()) return nullptr;
    const auto found = extras->find("tyndall");
    return found == extras->end() ? nullptr : &*found;
}

/// Metres along the light's axis to the farthest corner of the scene.
double extentAlong(const glm::dmat4& worldFromLight, const Bounds& bounds) {
    double farthest = 0.0;
    for (int corner = 0; corner < 8 && !bounds.empty(); ++corner) {
        const glm::dvec3 point(corner & 1 ? bounds.maximum.x : bounds.minimum.x,
                               corner & 2 ? bounds.maximum.y : bounds.minimum.y,
                               corner & 4 ? bounds.maximum.z : bounds.minimum.z);
        farthest = std::max(farthest, glm::dot(point - glm::dvec3(worldFromLight[3]), -glm::dvec3(worldFromLight[2])));
    }
    return farthest;
}

/// A little more than the scene, so that its last surface is lit and casts a shadow.
constexpr double extentMargin = 1.01;
/// For a light without range and without a scene in front of it.
constexpr double emptySceneFar = 20.0;

Result<void> applyRange(Light& light, const LightExtras& extras, double range, const Bounds& bounds,
                        const std::string& place) {
    light.nearPlane = extras.nearPlane.value_or(light.nearPlane);
    if (!(light.nearPlane > 0.0))
        return fail("{}: its near plane lies at {:g} m; move it in front of the lamp, above 0", place, light.nearPlane);
    const double extent = extentMargin * extentAlong(light.worldFromLight, bounds);
    light.farPlane = extras.farPlane            ? *extras.farPlane
                     : range > 0.0              ? range
                     : extent > light.nearPlane ? extent
                                                : light.nearPlane + emptySceneFar;
    if (!(light.farPlane > light.nearPlane))
        return fail("{}: its near plane ({:g} m) lies beyond its far plane ({:g} m); exchange or move them", place,
                    light.nearPlane, light.farPlane);
    return {};
}

Result<void> applyFov(Light& light, const LightExtras& extras, double outer, const std::string& place,
                      std::vector<std::string>& warnings) {
    light.fov = glm::dvec2(2.0 * outer);
    if (extras.fovDegrees && extras.shape == Shape::Frustum) light.fov = *extras.fovDegrees * degree;
    if (extras.fovDegrees && extras.shape == Shape::Cone)
        warnings.push_back(place +
                           ": extras.tyndall.fov is ignored, because a cone takes its angle from the lamp; "
                           "set shape to \"frustum\" to use it");
    for (const double angle : {light.fov.x, light.fov.y})
        if (!(angle > 0.0 && angle < std::numbers::pi * (1.0 - 1e-9)))
            return fail("{}: its field of view is {:g} degrees; it must lie between 0 and 180", place, angle / degree);
    return {};
}

Result<void> applyAir(Light& light, const LightExtras& extras, const std::string& place) {
    light.density = extras.density.value_or(light.density);
    light.ambient = extras.ambient.value_or(light.ambient);
    light.anisotropy = extras.anisotropy.value_or(light.anisotropy);
    light.albedo = extras.albedo;
    light.shadow = extras.shadow != Shadow::None;
    light.clipPlanes = extras.clipPlanes;
    if (!(light.density >= 0.0))
        return fail("{}: its density is {:g} 1/m; it cannot be negative", place, light.density);
    if (!(light.ambient >= 0.0)) return fail("{}: its ambient is {:g}; it cannot be negative", place, light.ambient);
    if (!(std::abs(light.anisotropy) < 1.0))
        return fail("{}: its anisotropy is {:g}; it must be between -1 and 1, excluding both", place, light.anisotropy);
    if (light.albedo && !(*light.albedo > 0.0 && *light.albedo <= 1.0))
        return fail("{}: its albedo is {:g}; it must be above 0 and at most 1, or absent for air without extinction",
                    place, *light.albedo);
    if (!extras.noise) return {};
    Noise noise;
    noise.scale = extras.noise->scale.value_or(noise.scale);
    noise.scroll1 = extras.noise->scroll1.value_or(noise.scroll1);
    noise.scroll2 = extras.noise->scroll2.value_or(noise.scroll2);
    noise.gain = extras.noise->gain.value_or(noise.gain);
    if (!(noise.gain >= 0.0)) return fail("{}: its noise gain is {:g}; it cannot be negative", place, noise.gain);
    light.noise = noise;
    return {};
}

}  // namespace

Result<ReadLight> readSpotLight(const Document& document, std::size_t node, std::optional<std::size_t> parent,
                                const glm::dmat4& pose, const Bounds& bounds, std::vector<std::string>& warnings) {
    const tinygltf::Model& model = document.model;
    const auto lamp = document.json["nodes"][node]["extensions"]["KHR_lights_punctual"]["light"].get<std::size_t>();
    const tinygltf::Light& source = model.lights[lamp];

    ReadLight read;
    Light& light = read.light.light;
    light.name = !model.nodes[node].name.empty() ? model.nodes[node].name
                 : !source.name.empty()          ? source.name
                                                 : fmt::format("light {}", lamp);
    const std::string place = fmt::format("light \"{}\"", light.name);
    auto rigid = rigidPart(pose, place);
    if (!rigid) return tl::unexpected(rigid.error());
    light.worldFromLight = *rigid;

    light.intensity = source.intensity;
    if (source.color.size() == 3) light.colour = glm::dvec3(source.color[0], source.color[1], source.color[2]);
    if (!(light.intensity >= 0.0) || glm::any(glm::lessThan(light.colour, glm::dvec3(0.0))))
        return fail("{}: its intensity and colour cannot be negative; set them to 0 or more", place);

    const nlohmann::json* written = tyndallExtras(document, node);
    if (written == nullptr && parent) written = tyndallExtras(document, *parent);
    LightExtras extras;
    if (written != nullptr) {
        auto found = readLightExtras(*written, place, warnings);
        if (!found) return tl::unexpected(found.error());
        extras = std::move(*found);
    }
    if (auto done = applyRange(light, extras, source.range, bounds, place); !done) return tl::unexpected(done.error());
    if (auto done = applyFov(light, extras, source.spot.outerConeAngle, place, warnings); !done)
        return tl::unexpected(done.error());
    if (auto done = applyAir(light, extras, place); !done) return tl::unexpected(done.error());
    read.light.movingShadow = extras.shadow == Shadow::Dynamic;
    if (extras.noise) read.noiseTexture = extras.noise->texture;
    read.cookieTexture = extras.cookie;
    if (extras.shape == Shape::Cone) {
        const double inner = source.spot.innerConeAngle, outer = source.spot.outerConeAngle;
        if (!(inner >= 0.0 && inner <= outer))
            return fail("{}: its inner cone angle of {:g} degrees must lie between 0 and the outer one of {:g}", place,
                        inner / degree, outer / degree);
        read.light.cone = ConeAngles{inner, outer};
    }
    light.cookie = read.cookieTexture || read.light.cone;
    return read;
}

}  // namespace tyndall::app

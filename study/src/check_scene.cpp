#include "check_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tyndall::study {
namespace {

using Checked = Result<void>;

template <class... Args>
tl::unexpected<Error> broken(fmt::format_string<Args...> text, Args&&... args) {
    return tl::unexpected(Error{ErrorCode::InvalidArgument, fmt::format(text, std::forward<Args>(args)...)});
}

bool finite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

bool rigid(const glm::dmat4& pose) {
    const glm::dmat3 r(pose);
    const glm::dmat3 off = glm::transpose(r) * r - glm::dmat3(1.0);
    double maxOff = 0.0;
    for (int i = 0; i < 9; ++i) maxOff = std::max(maxOff, std::abs(off[i / 3][i % 3]));
    return finite(pose) && maxOff <= 1e-6 && glm::determinant(r) > 0.0;
}

Checked checkTexture(const std::string& place, const Image& texture, int channels) {
    if (texture.width < 1 || texture.height < 1)
        return broken("{} is {}x{} texels: it must have some; give the light its texture, or turn the term off", place,
                      texture.width, texture.height);
    if (texture.channels < channels)
        return broken("{} has {} channels: it must have at least {}; add the missing ones", place, texture.channels,
                      channels);
    const std::size_t expected = static_cast<std::size_t>(texture.width) * texture.height * texture.channels;
    if (texture.values.size() != expected)
        return broken("{} holds {} values: {}x{} texels of {} channels take {}; give it all of them", place,
                      texture.values.size(), texture.width, texture.height, texture.channels, expected);
    for (std::size_t i = 0; i < expected; ++i)
        if (!(std::isfinite(texture.values[i]) && texture.values[i] >= 0.0f))
            return broken("{} holds {} at value {}: it must be finite and not negative; mend the image", place,
                          texture.values[i], i);
    return {};
}

// Texels of noise across the light's field of view: each is a breakpoint of every ray that crosses it.
constexpr double maxNoiseTexels = 1e5;

Checked checkNoise(const std::string& place, const Noise& noise, const Image& texture, double time) {
    for (const double number :
         {noise.gain, noise.scroll1.x * time, noise.scroll1.y * time, noise.scroll2.x * time, noise.scroll2.y * time})
        if (!std::isfinite(number))
            return broken("{}: its noise has a gain or a scroll times time of {}: both must be finite; lower them",
                          place, number);
    if (noise.gain < 0.0) return broken("{}: its noise has a gain of {}: it cannot be negative", place, noise.gain);
    const double texels = std::max(std::abs(noise.scale.x) * texture.width, std::abs(noise.scale.y) * texture.height);
    if (!(texels <= maxNoiseTexels))
        return broken(
            "{}: its noise is repeated over {} texels of the field of view: the maximum is {}; lower "
            "its scale",
            place, texels, maxNoiseTexels);
    return {};
}

Checked checkLight(const ReferenceLight& reference, std::size_t index, Mode mode, double time) {
    const Light& light = reference.light;
    const std::string place = fmt::format("light {}{}", index, light.name.empty() ? "" : " \"" + light.name + "\"");
    if (!rigid(light.worldFromLight))
        return broken("{}: worldFromLight must be a finite rotation and translation; take scale and shear out", place);
    for (const double angle : {light.fov.x, light.fov.y})
        if (!(angle > 0.0 && angle < std::numbers::pi))
            return broken("{}: its field of view of {} radians must lie between 0 and pi; correct it", place, angle);
    if (!(light.nearPlane > 0.0 && light.farPlane > light.nearPlane && std::isfinite(light.farPlane)))
        return broken("{}: its planes at {} and {} m must be 0 < near < far and finite; correct them", place,
                      light.nearPlane, light.farPlane);
    for (const double strength :
         {light.colour.r, light.colour.g, light.colour.b, light.intensity, light.density, light.ambient})
        if (!(strength >= 0.0 && std::isfinite(strength)))
            return broken("{}: a strength of {} must be finite and not negative; correct it", place, strength);
    if (!(std::abs(light.anisotropy) < 1.0))
        return broken("{}: its anisotropy of {} must lie between -1 and 1, both excluded; correct it", place,
                      light.anisotropy);
    if (light.albedo && !(*light.albedo > 0.0 && *light.albedo <= 1.0))
        return broken("{}: its albedo of {} must be over 0 and at most 1; correct it, or leave it out for clear air",
                      place, *light.albedo);
    if (light.albedo && !std::isfinite(light.density / *light.albedo))
        return broken("{}: its density of {} over its albedo of {} must be finite; raise the albedo", place,
                      light.density, *light.albedo);
    for (const glm::dvec4& plane : light.clipPlanes)
        if (!std::isfinite(plane.x + plane.y + plane.z + plane.w) || glm::length(glm::dvec3(plane)) == 0.0)
            return broken("{}: a clip plane must be finite and have a normal; correct it", place);
    if (const auto& cone = reference.cone)
        if (!(cone->inner >= 0.0 && cone->outer >= cone->inner && cone->outer < 0.5 * std::numbers::pi))
            return broken("{}: its cone's half angles {} and {} must be 0 <= inner <= outer < pi / 2; correct them",
                          place, cone->inner, cone->outer);
    if (light.cookie)
        if (auto checked = checkTexture(place + ": its cookie", reference.cookie, 3); !checked) return checked;
    if (light.noise) {
        if (auto checked = checkTexture(place + ": its noise", reference.noise, 2); !checked) return checked;
        if (auto checked = checkNoise(place, *light.noise, reference.noise, time); !checked) return checked;
    }
    if (light.shadow && mode == Mode::Hardware) {
        if (auto checked = checkTexture(place + ": its shadow map", reference.shadowMap, 1); !checked) return checked;
        if (reference.shadowMap.width != reference.shadowMap.height || reference.shadowMap.channels != 1)
            return broken("{}: its shadow map of {}x{} texels and {} channels must be square and of one channel", place,
                          reference.shadowMap.width, reference.shadowMap.height, reference.shadowMap.channels);
    }
    return {};
}

}  // namespace

Checked checkScene(const ReferenceScene& scene, const ReferenceOptions& options) {
    if (scene.width < 1 || scene.height < 1)
        return broken("the picture is {}x{} pixels: it must have some; give both sides 1 or more", scene.width,
                      scene.height);
    if (!(options.accuracy >= 1e-12 && options.accuracy <= 1.0))
        return broken("accuracy is {}: it must lie from 1e-12, the limit of doubles, to 1; 1e-8 is a good choice",
                      options.accuracy);
    if (!std::isfinite(scene.time)) return broken("time must be a finite number of seconds");
    const View& view = scene.view;
    if (!rigid(view.worldFromView))
        return broken("the view: worldFromView must be a finite rotation and translation; take scale and shear out");
    if (!finite(view.clipFromView) || glm::determinant(view.clipFromView) == 0.0)
        return broken("the view: clipFromView must be finite and invertible; see perspectiveView()");
    if (!(view.nearPlane > 0.0 && view.farPlane > view.nearPlane))
        return broken("the view: its planes at {} and {} m must be 0 < near < far; correct them", view.nearPlane,
                      view.farPlane);
    if (!scene.depth.values.empty()) {
        if (auto checked = checkTexture("the scene's depth", scene.depth, 1); !checked) return checked;
        if (scene.depth.width != scene.width || scene.depth.height != scene.height || scene.depth.channels != 1)
            return broken("the scene's depth of {}x{} must be of the picture's size, {}x{}, and of one channel",
                          scene.depth.width, scene.depth.height, scene.width, scene.height);
    }
    if (!(scene.shadowBias >= 0.0 && std::isfinite(scene.shadowBias)))
        return broken("shadowBias is {} m: it must be finite and not negative", scene.shadowBias);
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (auto checked = checkLight(scene.lights[i], i, scene.mode, scene.time); !checked) return checked;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i)
        for (const glm::dvec3& p : {scene.triangles[i].a, scene.triangles[i].b, scene.triangles[i].c})
            if (!std::isfinite(p.x + p.y + p.z))
                return broken("triangle {} must have finite corners; mend the mesh", i);
    return {};
}

}  // namespace tyndall::study

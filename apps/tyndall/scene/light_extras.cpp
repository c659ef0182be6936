#include "light_extras.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace tyndall::app {
namespace {

using nlohmann::json;

struct Wrong {
    std::string sentence;
};

[[noreturn]] void wrong(const std::string& place, const char* key, const char* rule, const json& value) {
    std::string shown = value.dump(-1, ' ', false, json::error_handler_t::replace);
    if (shown.size() > 40) shown = shown.substr(0, 40) + "...";
    throw Wrong{fmt::format("{}: extras.tyndall.{} must be {}, but is {}", place, key, rule, shown)};
}

std::string joined(std::initializer_list<const char*> names) {
    std::string text;
    for (const char* name : names) text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
}

void warnOfUnknown(const json& object, std::initializer_list<const char*> known, const std::string& place,
                   const char* where, std::vector<std::string>& warnings) {
    for (const auto& [key, value] : object.items())
        if (std::ranges::find(known, std::string_view(key)) == known.end())
            warnings.push_back(fmt::format("{}: {} has no setting \"{}\", which is ignored; it has {}", place, where,
                                           key, joined(known)));
}

double numberOf(const json& value, const std::string& place, const char* key, const char* rule) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) wrong(place, key, rule, value);
    return value.get<double>();
}

std::optional<double> number(const json& object, const char* key, const std::string& place) {
    const auto found = object.find(key);
    if (found == object.end()) return std::nullopt;
    return numberOf(*found, place, key, "a number");
}

std::optional<int> index(const json& object, const char* key, const std::string& place) {
    const auto found = object.find(key);
    if (found == object.end()) return std::nullopt;
    if (!found->is_number_unsigned() || found->get<std::uint64_t>() > 1'000'000'000)
        wrong(place, key, "the index of a texture, counted from 0", *found);
    return found->get<int>();
}

std::optional<glm::dvec2> pair(const json& object, const char* key, const std::string& place) {
    const auto found = object.find(key);
    if (found == object.end()) return std::nullopt;
    if (!found->is_array() || found->size() != 2) wrong(place, key, "two numbers", *found);
    return glm::dvec2(numberOf((*found)[0], place, key, "two numbers"),
                      numberOf((*found)[1], place, key, "two numbers"));
}

template <class T>
T choice(const json& object, const char* key, const std::string& place, T fallback, const char* rule,
         std::initializer_list<std::pair<const char*, T>> choices) {
    const auto found = object.find(key);
    if (found == object.end()) return fallback;
    for (const auto& [name, value] : choices)
        if (*found == name) return value;
    wrong(place, key, rule, *found);
}

std::vector<glm::dvec4> clipPlanes(const json& object, const std::string& place) {
    std::vector<glm::dvec4> planes;
    const auto found = object.find("clipPlanes");
    if (found == object.end()) return planes;
    constexpr const char* rule = "at most 6 planes of 4 numbers each, the first three not all 0";
    if (!found->is_array() || found->size() > 6) wrong(place, "clipPlanes", rule, *found);
    for (const json& plane : *found) {
        if (!plane.is_array() || plane.size() != 4) wrong(place, "clipPlanes", rule, *found);
        glm::dvec4 values;
        for (int i = 0; i < 4; ++i) values[i] = numberOf(plane[static_cast<std::size_t>(i)], place, "clipPlanes", rule);
        const double length = glm::length(glm::dvec3(values));
        if (!(length > 0.0) || !std::isfinite(length)) wrong(place, "clipPlanes", rule, *found);
        planes.push_back(values / length);
    }
    return planes;
}

LightExtras read(const json& extras, const std::string& place, std::vector<std::string>& warnings) {
    if (!extras.is_object())
        throw Wrong{
            fmt::format("{}: extras.tyndall must be an object of settings, but is {}", place, extras.type_name())};
    warnOfUnknown(extras,
                  {"shape", "fov", "near", "far", "cookie", "shadow", "noise", "density", "ambient", "anisotropy",
                   "albedo", "clipPlanes"},
                  place, "extras.tyndall", warnings);
    LightExtras light;
    light.shape = choice<Shape>(extras, "shape", place, Shape::Cone, "\"cone\" or \"frustum\"",
                                {{"cone", Shape::Cone}, {"frustum", Shape::Frustum}});
    light.fovDegrees = pair(extras, "fov", place);
    light.nearPlane = number(extras, "near", place);
    light.farPlane = number(extras, "far", place);
    light.cookie = index(extras, "cookie", place);
    light.shadow = choice<Shadow>(extras, "shadow", place, Shadow::Static, "\"none\", \"static\" or \"dynamic\"",
                                  {{"none", Shadow::None}, {"static", Shadow::Static}, {"dynamic", Shadow::Dynamic}});
    light.density = number(extras, "density", place);
    light.ambient = number(extras, "ambient", place);
    light.anisotropy = number(extras, "anisotropy", place);
    light.albedo = number(extras, "albedo", place);
    light.clipPlanes = clipPlanes(extras, place);

    const auto noise = extras.find("noise");
    if (noise == extras.end()) return light;
    if (!noise->is_object() || !noise->contains("texture"))
        wrong(place, "noise", "an object that names at least a \"texture\"", *noise);
    warnOfUnknown(*noise, {"texture", "scale", "scroll1", "scroll2", "gain"}, place, "extras.tyndall.noise", warnings);
    light.noise = NoiseExtras{.texture = *index(*noise, "texture", place),
                              .scale = pair(*noise, "scale", place),
                              .scroll1 = pair(*noise, "scroll1", place),
                              .scroll2 = pair(*noise, "scroll2", place),
                              .gain = number(*noise, "gain", place)};
    return light;
}

}  // namespace

Result<LightExtras> readLightExtras(const json& extras, const std::string& place, std::vector<std::string>& warnings) {
    try {
        return read(extras, place, warnings);
    } catch (const Wrong& found) {
        return failWith(found.sentence);
    }
}

}  // namespace tyndall::app

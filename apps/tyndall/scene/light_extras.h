// A light's extras.tyndall as written; absent settings stay absent.
#pragma once

#include <kit/fail.h>

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tyndall::app {

struct NoiseExtras {
    int texture = 0;
    std::optional<glm::dvec2> scale, scroll1, scroll2;
    std::optional<double> gain;
};

enum class Shape { Cone, Frustum };
enum class Shadow { None, Static, Dynamic };

struct LightExtras {
    Shape shape = Shape::Cone;
    std::optional<glm::dvec2> fovDegrees;
    std::optional<double> nearPlane, farPlane, density, ambient, anisotropy, albedo;
    std::optional<int> cookie;
    Shadow shadow = Shadow::Static;
    std::optional<NoiseExtras> noise;
    std::vector<glm::dvec4> clipPlanes;
};

/// Reads the object; `place` names the light in messages. An unknown key gives a warning, a
/// value of the wrong kind an error.
Result<LightExtras> readLightExtras(const nlohmann::json& extras, const std::string& place,
                                    std::vector<std::string>& warnings);

}  // namespace tyndall::app

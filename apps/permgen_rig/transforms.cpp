#include "transforms.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace tyndall::rig {
namespace {

glm::dvec3 vector3(const JsonValue& value) {
    const auto list = value.list();
    if (list.size() != 3) value.fail("a point or direction has 3 numbers, not {}", list.size());
    return {list[0].number(), list[1].number(), list[2].number()};
}

glm::dvec3 direction(const JsonValue& value) {
    const glm::dvec3 v = vector3(value);
    if (!(glm::length(v) > 0.0)) value.fail("a direction must be longer than 0");
    return v;
}

// Clip space is Vulkan's, y down and depth 0 to 1; view space looks along -Z with +Y up.
glm::dmat4 perspective(const JsonValue& value) {
    value.allowOnly({"fov", "aspect", "near", "far"});
    const double fov = glm::radians(value.at("fov").number(0.1, 179.0));
    const double aspect = value.has("aspect") ? value.at("aspect").number(1e-3, 1e3) : 1.0;
    const double near = value.at("near").number(1e-6, 1e9);
    const double far = value.at("far").number(0.0, 1e12);
    if (!(far > near)) value.fail("\"far\" must be beyond \"near\"");
    const double halfFov = 0.5 * fov;
    const double scale = 1.0 / std::tan(halfFov);
    glm::dmat4 m(0.0);
    m[0][0] = scale / aspect;
    m[1][1] = -scale;
    m[2][2] = far / (near - far);
    m[2][3] = -1.0;
    m[3][2] = near * far / (near - far);
    return m;
}

glm::dmat4 lookAt(const JsonValue& value) {
    value.allowOnly({"eye", "target", "up"});
    const glm::dvec3 eye = vector3(value.at("eye")), target = vector3(value.at("target"));
    const glm::dvec3 up = value.has("up") ? direction(value.at("up")) : glm::dvec3(0.0, 1.0, 0.0);
    if (!(glm::length(glm::cross(target - eye, up)) > 0.0))
        value.fail("the view from \"eye\" to \"target\" cannot run along \"up\"");
    return glm::lookAt(eye, target, up);
}

glm::dmat4 rotation(const JsonValue& value) {
    value.allowOnly({"axis", "degrees"});
    return glm::rotate(glm::dmat4(1.0), glm::radians(value.at("degrees").number()), direction(value.at("axis")));
}

// Deeper than any fixture needs; recursion this deep does not fill the stack.
constexpr int deepestProduct = 16;

glm::dmat4 matrix(const JsonValue& value, int depth = 0) {
    value.allowOnly({"identity", "perspective", "lookAt", "rotate", "scale", "translate", "product"});
    const auto members = value.members();
    if (members.size() != 1) value.fail("a matrix must be exactly one of these; put several into \"product\"");
    const auto& [name, inner] = members[0];
    if (name == "perspective") return perspective(inner);
    if (name == "lookAt") return lookAt(inner);
    if (name == "rotate") return rotation(inner);
    if (name == "scale") return glm::scale(glm::dmat4(1.0), vector3(inner));
    if (name == "translate") return glm::translate(glm::dmat4(1.0), vector3(inner));
    glm::dmat4 all(1.0);
    if (name != "product") return all;
    if (depth == deepestProduct)
        inner.fail("products nest at most {} deep; write the factors of the inner ones into one list", deepestProduct);
    for (const JsonValue& factor : inner.list()) all = all * matrix(factor, depth + 1);
    return all;
}

}  // namespace

bool isTransform(const JsonValue& value) {
    return value.json().is_object();
}

Numbers readTransform(const JsonValue& value) {
    const glm::dmat4 m = matrix(value);
    Numbers numbers{{}, {4, 4}};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) numbers.values.push_back(m[column][row]);
    return numbers;
}

}  // namespace tyndall::rig

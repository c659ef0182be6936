#include "visibility/view_pose.h"

namespace tyndall {
namespace {

glm::dmat4 affine(const glm::dmat3& linear, const glm::dvec3& translation) {
    glm::dmat4 matrix(linear);
    matrix[3] = glm::dvec4(translation, 1.0);
    return matrix;
}

}  // namespace

LightPose lightPose(const glm::dmat4& worldFromLight, const glm::dmat4& worldFromView) {
    const glm::dmat3 light(worldFromLight);
    const glm::dmat3 eye(worldFromView);
    const glm::dvec3 lightFromEye(worldFromLight[3] - worldFromView[3]);
    // Inverses, not transposes: a matrix may differ from a rigid one by plan()'s tolerance. Only the true inverse then
    // agrees with the matrix that the caller draws the scene with.
    const glm::dmat3 eyeInverse = glm::inverse(eye);
    const glm::dmat3 lightInverse = glm::inverse(light);
    return {affine(eyeInverse * light, eyeInverse * lightFromEye),
            affine(lightInverse * eye, -(lightInverse * lightFromEye))};
}

glm::dvec4 viewPlane(const glm::dvec4& worldPlane, const glm::dmat4& worldFromView) {
    const glm::dvec3 normal(worldPlane);
    const glm::dvec3 eye(worldFromView[3]);
    const glm::dvec3 viewNormal = glm::transpose(glm::dmat3(worldFromView)) * normal;
    return unitPlane(glm::dvec4(viewNormal, glm::dot(normal, eye) + worldPlane.w));
}

}  // namespace tyndall

#include "shape/attenuation.h"

#include <algorithm>

namespace tyndall {

double maxAttenuation(const Light& light) {
    return light.intensity / (light.nearPlane * light.nearPlane) + light.ambient;
}

double maxAttenuationAlong(const Light& light, double minAxis, double maxLength, double maxSlab) {
    const double inverseSquares = std::min(maxLength / (minAxis * minAxis), (4.0 + maxSlab / minAxis) / minAxis);
    return light.intensity * inverseSquares + light.ambient * maxLength;
}

}  // namespace tyndall

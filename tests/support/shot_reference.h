// The integral that a shot's picture approximates, by the library study.
#pragma once

#include <study/reference.h>

#include <vector>

#include "oracle.h"
#include "picture.h"

namespace tyndall::test {

study::Image studyTexture(const Texture& texture);

/// The radiance of the shot's pixels, by row. `depthExtent`: metres of view depth of the light's volume; the published
/// constants belong to it. The published weights count depth, not the ray's length.
std::vector<glm::dvec3> truth(const Shot& shot, double depthExtent);

/// The root of the mean square of the differences over that of the exact values.
double relativeL2(const Picture& picture, const std::vector<glm::dvec3>& exact);

}  // namespace tyndall::test

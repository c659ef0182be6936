// Set-ups for the reference's tests.
#pragma once

#include <study/reference.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <random>

namespace tyndall::test {

/// A perspective eye with reversed depth that looks from `position` along `direction`.
View eye(glm::dvec3 position, glm::dvec3 direction, double verticalFov = 0.8, double nearPlane = 0.1,
         double farPlane = 100.0);

/// Parallel rays instead, over `halfHeight` metres to either side.
View parallelEye(glm::dvec3 position, glm::dvec3 direction, double halfHeight, double nearPlane = 0.1,
                 double farPlane = 100.0);

/// White lamp at the world's origin that looks along -Z: 90 by 60 degrees, from 0.5 m to 4 m, without any mask.
Light plainLight();

/// The near plane of oneRay()'s eye, metres.
inline constexpr double oneRayNear = 0x1p-10;

/// One light without textures, seen through one pixel: the ray runs from `position` along `direction`.
study::ReferenceScene oneRay(const Light& light, glm::dvec3 position, glm::dvec3 direction);

/// The only pixel of a scene of 1x1, or the message as an exception.
glm::dvec3 radianceOf(const study::ReferenceScene& scene, double accuracy = 1e-10);

/// A pane with corners a, b, c, d in turn, seen from both sides.
std::vector<study::Triangle> pane(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d);

/// Values in [low, 1], the same on every machine.
study::Image speckle(int width, int height, int channels, std::uint64_t seed, double low = 0.0);

using Random = std::mt19937_64;
double uniform(Random& random, double low, double high);
glm::dvec3 direction(Random& random);

/// Up to three lights with random terms, random panes between them, an eye somewhere near, 9 x 7 pixels.
study::ReferenceScene randomScene(std::uint64_t seed, study::Mode mode);

/// The same in thicker air, with g from -0.95 to 0.95 and, for two lights of three, an albedo; every third scene has
/// parallel rays.
study::ReferenceScene scatteringScene(std::uint64_t seed, study::Mode mode);

}  // namespace tyndall::test

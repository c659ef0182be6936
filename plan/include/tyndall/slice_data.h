// The data that the slice shaders read, as bytes. shaders/slices.fx explains each value;
// runtime/src/effect_contract.cpp asserts at compile time that both agree.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace tyndall {

/// One vertex of a slice; 20 bytes.
struct SliceVertex {
    glm::vec3 position;         ///< metres in view space (exact polygons) or unit cube (stretched quads)
    float thickness;            ///< of the slab: metres (exact polygons) or share of the extent (stretched quads)
    std::uint32_t channelMask;  ///< RGBA8 unorm, red in the lowest byte
};
static_assert(sizeof(SliceVertex) == 20);

/// The uniform block of slices.fx, one for each planned light.
struct SliceConstants {
    glm::mat4 clipFromView;
    glm::mat4 lightFromView;
    glm::vec4 boundsMin;
    glm::vec4 boundsMax;
    glm::vec4 clipPlanes[8];
    glm::vec4 cookieScale;
    glm::vec4 attenuation;
    glm::vec4 dust;
    glm::vec4 noise1;
    glm::vec4 noise2;
    glm::vec4 colour;
    glm::vec4 weight;
    glm::vec4 shadow;
    glm::vec4 scattering;
    glm::vec4 eye;
};

}  // namespace tyndall

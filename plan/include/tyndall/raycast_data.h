// The data that the shaders of raycast.fx read, as bytes. shaders/raycast.fx explains each value;
// runtime/src/effect_contract.cpp asserts at compile time that both agree. The vertices are those of slices, with clip
// coordinates as positions.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace tyndall {

/// The uniform block of raycast.fx, one for each light that is drawn so. plan() leaves `surface.z`, `pixel.xy` and
/// `texels` to the recording: they depend on the caller's images.
struct RaycastConstants {
    glm::vec4 origin[3];
    glm::vec4 direction[3];
    glm::vec4 planes[18];
    glm::vec4 volume;
    glm::vec4 depths;
    glm::vec4 surface;
    glm::vec4 pixel;
    glm::vec4 texels;
    glm::vec4 cookieScale;
    glm::vec4 attenuation;
    glm::vec4 dust;
    glm::vec4 noise1;
    glm::vec4 noise2;
    glm::vec4 colour;
    glm::vec4 weight;
    glm::vec4 shadow;
    glm::vec4 scattering;
    glm::vec4 channels;
};

/// Levels of the shadow hierarchy of a map with `size` texels a side: the mip levels of an image whose first level has
/// shadowHierarchySide() texels a side. See shaders/shadow_hierarchy.fx.
std::uint32_t shadowHierarchyLevels(std::uint32_t size);
std::uint32_t shadowHierarchySide(std::uint32_t size);

}  // namespace tyndall

// The shape of a light: the volume that it fills, and how its slide is projected into that volume.
//
// The planner's stages use a shape through functions alone: pyramid.h (the volume), slide.h (the slide's uv),
// shadow_projection.h (the shadow map) and attenuation.h (how strong the light is). A point light's six faces are six
// pyramids. Another kind of shape, such as the parallel beam of a sun, is one more struct with the functions of
// pyramid.h, in its own file. LightShape then becomes a std::variant of both, and only this folder changes.
#pragma once

#include "shape/pyramid.h"

namespace tyndall {

using LightShape = Pyramid;

inline LightShape shapeOf(const Light& light) {
    return pyramidOf(light);
}

}  // namespace tyndall

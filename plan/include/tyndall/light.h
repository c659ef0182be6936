// A projector: a lamp that throws a slide through dusty air.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tyndall {

/// Two noise maps drifting over each other, projected like the cookie: gain * red(uv1) * green(uv2),
/// where uvN = uv * scale + scrollN * time.
struct Noise {
    glm::dvec2 scale{3.0, 3.0};      ///< repeats over the field of view
    glm::dvec2 scroll1{0.02, 0.01};  ///< repeats per second
    glm::dvec2 scroll2{-0.015, 0.02};
    double gain = 1.0 / 0.3;
};

/// A spot light whose volume is the pyramid of its field of view, cut at `nearPlane` and `farPlane`.
/// Every number must be finite, every strength and Noise::gain 0 or more.
struct Light {
    std::string name;                    ///< for plans and messages only
    glm::dmat4 worldFromLight{1.0};      ///< looks along -Z, +Y up; rigid: its columns' dot products are
                                         ///< within 1e-6 of a rotation's, its position within 1e9 m
    glm::dvec2 fov{0.7, 0.7};            ///< full horizontal and vertical angle, radians; 0.01 to 179 degrees
    double nearPlane = 0.05;             ///< metres along the axis, 1e-6 to 1e9
    double farPlane = 20.0;              ///< metres along the axis, > nearPlane, at most 1e9
    glm::dvec3 colour{1.0};              ///< linear Rec. 709, multiplies intensity
    double intensity = 1.0;              ///< candela
    double density = 0.02;               ///< of the scattering air, 1/m
    double ambient = 0.0;                ///< added to I/d^2, cd/m^2
    double anisotropy = 0.0;             ///< Henyey and Greenstein's g, in (-1, 1); above 0 the air scatters forwards
    std::optional<double> albedo;        ///< of the air, in (0, 1]: extinction is density / albedo; absent: none
    bool cookie = false;                 ///< has a projected texture
    bool shadow = true;                  ///< occluders in its cone throw shadows through the air
    std::optional<Noise> noise;          ///< dust; absent: evenly filled air
    std::vector<glm::dvec4> clipPlanes;  ///< world space, keeps dot(n, p) + d >= 0; at most 6 (2 with
                                         ///< stretched quads); n of any length from 1e-6
};

/// Half the width and height of the light's volume, for each metre along its axis.
glm::dvec2 tanHalfFov(const Light& light);

/// Metres from the lamp to the farthest corner of its volume.
double maxDistance(const Light& light);

/// The depth that the light's shadow map stores for a surface `w` metres along the light's axis:
/// constant + overAxis / w. See lightClipFromLight().
struct ShadowDepth {
    double constant, overAxis;
};
ShadowDepth shadowDepth(const Light& light);

/// World-to-light-clip projection of the light's shadow map, Vulkan conventions (y down, depth 0..1),
/// reversed: depth 1 at the near plane and 0 at the far plane. x right, y up in light space map to
/// u right, v down in the map, as for the cookie.
/// light.fov, nearPlane and farPlane must be valid (see plan()).
glm::dmat4 lightClipFromLight(const Light& light);

/// lightClipFromLight() of points in world space: drawing a shadow map and selecting its occluders use the same
/// projection.
glm::dmat4 lightClipFromWorld(const Light& light);

}  // namespace tyndall

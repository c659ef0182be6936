// What a frame will draw, and why: pure CPU work in double precision, no Vulkan device.
#pragma once

#include <tyndall/light.h>
#include <tyndall/result.h>
#include <tyndall/slice_data.h>
#include <tyndall/view.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall {

/// How slices become triangles.
enum class Geometry {
    ExactPolygons,   ///< each slice is the convex polygon of its plane with the light's volume
    StretchedQuads,  ///< as published: unit-cube quads stretched over the bounds, cut by clip distances
};

/// Where slices are added up.
enum class Accumulation {
    Rgba8,        ///< 8 bits a channel
    Rgba8Routed,  ///< slice i into channel i mod 4, one grey value, summed on compositing
    Rgba16f,
    Rgba32f,
};

/// Which constants weigh a slice.
enum class Look {
    Physical,  ///< the radiance of slices.fx's formula, independent of the number of slices
    Article,   ///< the published constants: 0.25 + 20000/d^2 with d in inches, noise gain 0.05 or 0.015
               ///< flat, weight 9/f with f the slices over 100; no slab thickness, slant, density or gain
};

struct PlanOptions {
    int slices = 100;  ///< a light, 1 to 65536; a multiple of 4 when routed
    Geometry geometry = Geometry::ExactPolygons;
    Accumulation accumulation = Accumulation::Rgba16f;
    Look look = Look::Physical;
    double time = 0.0;                          ///< seconds; scrolls the noise
    double range = 1.0;                         ///< radiance that the value 1 of an 8-bit target stands for, > 0;
                                                ///< float targets hold radiance itself
    std::uint32_t shadowMapSize = 1024;         ///< texels a side, 1 to 65536, as the caller draws it
    double shadowBias = 0.0;                    ///< metres along the light's axis, 0 to 1e9; at most 0.99 of a light's
                                                ///< nearPlane takes effect, or points would fall behind the lamp
    std::optional<std::string_view> technique;  ///< draws every light with this one, whatever it calls for; a
                                                ///< light that lacks what it reads sees a neutral texture there
};

/// One light's part of the plan. Where `drawn` is false, everything from `slices` on is zero.
struct PlannedLight {
    std::size_t light = 0;       ///< index into the lights that were given
    bool drawn = false;          ///< false: it adds nothing to this view, dark, hidden or outside
    std::string reason;          ///< why it is drawn with this technique, or not at all; one sentence
    std::string_view technique;  ///< name in slices.fx
    bool noise = false, shadow = false, cookie = false;  ///< the technique's switches
    int slices = 0;
    double nearDepth = 0.0, farDepth = 0.0;        ///< metres of view depth that the slabs span
    std::uint32_t firstIndex = 0, indexCount = 0;  ///< into Plan::indices; stretched quads are shared by lights
    std::size_t group = 0;                         ///< into Plan::groups
    SliceConstants constants{};
};

/// Lights that are added up in one target before it is composited. One holds them all, except for the
/// routed format, whose four channels carry one grey value: there every chromaticity has its own. The grey
/// value is the light's strongest channel times the luminance of its cookie: a coloured cookie keeps its
/// pattern and takes the light's colour.
struct CompositeGroup {
    glm::vec3 tint{1.0f};             ///< multiplies the sum; routed, its largest component is 1
    std::vector<std::size_t> lights;  ///< indices into Plan::lights, drawn ones only
};

struct Plan {
    Geometry geometry = Geometry::ExactPolygons;
    Accumulation accumulation = Accumulation::Rgba16f;
    double scale = 1.0;  ///< target value = radiance * scale; compositing divides by it
    std::vector<SliceVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< triangle list into `vertices`
    std::vector<PlannedLight> lights;    ///< one for each light given, in their order
    std::vector<CompositeGroup> groups;  ///< none where no light is drawn
};

/// Plans the shafts of `lights` as `view` sees them.
///
/// Slices are perpendicular to the view direction, at the midpoints of equally thick slabs that span the
/// light's volume clamped to the view's near plane, far plane and scene depth. They come farthest first, are
/// convex and counter-clockwise as the eye sees them. A slice without area has no triangles. Far outside
/// the picture, at eight times its half width, slices are cut off.
///
/// The plan for lights and eye a thousand kilometres from the world's origin is as accurate as at it.
///
/// Errors: InvalidArgument where a value breaks the bounds stated in Light, View and PlanOptions, where
/// any of them is not finite (View::farPlane may be infinite), where the routed format meets a number of
/// slices that four does not divide, where stretched quads meet more than two extra clip planes, where
/// `technique` names none of slices.fx, where lights times slices exceed 2^24, or where a light's strength
/// or noise overflows the shader's floats. Lights that would not be drawn are checked too.
Result<Plan> plan(std::span<const Light> lights, const View& view, const PlanOptions& options);

/// The technique of slices.fx that has exactly these terms.
std::string_view techniqueName(bool noise, bool shadow, bool cookie);

}  // namespace tyndall

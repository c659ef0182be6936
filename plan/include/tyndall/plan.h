// What a frame will draw, and why: pure CPU work in double precision, no Vulkan device.
#pragma once

#include <tyndall/light.h>
#include <tyndall/method.h>
#include <tyndall/raycast_data.h>
#include <tyndall/result.h>
#include <tyndall/slice_data.h>
#include <tyndall/surroundings.h>
#include <tyndall/terms.h>
#include <tyndall/view.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
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

/// How the slabs of a light lie.
enum class Spacing {
    Even,      ///< as many as asked for, equally thick over the depths that the light's volume spans
    Adaptive,  ///< as many as needed: a slab's thickness grows with its distance from the lamp, like the texels of a
               ///< cookie and a shadow map; the minimum is a pixel, or less in a narrow beam. Counting starts at the
               ///< lamp's own depth, and the outermost slabs end with the volume, so nothing steps when eye or light
               ///< move. Look::Article keeps Even: its constants belong to equal slabs
};

struct PlanOptions {
    Method method = Method::Slices;
    // Method::Slices only: slices, spacing, geometry.
    int slices = 100;  ///< per light, 1 to 65536; a multiple of 4 when routed. Adaptive: the maximum; 2 are always
                       ///< allowed
    Spacing spacing = Spacing::Even;
    Geometry geometry = Geometry::ExactPolygons;
    Accumulation accumulation = Accumulation::Rgba16f;
    Look look = Look::Physical;
    double time = 0.0;                   ///< seconds; scrolls the noise
    double range = 1.0;                  ///< radiance that the value 1 of an 8-bit target stands for, > 0;
                                         ///< float targets hold radiance itself
    std::uint32_t shadowMapSize = 1024;  ///< texels a side, 1 to 65536, as the caller draws it
    double shadowBias = 0.0;             ///< metres along the light's axis, 0 to 1e9; plan() raises it before blockers
                                         ///< that the map's texels are too coarse for; at most 0.99 of a light's
                                         ///< nearPlane takes effect, so that points stay before the lamp
    std::optional<TermSet> terms;        ///< draws every light with these terms; a light that lacks a texture of its
                                         ///< technique gets a neutral one
    std::uint32_t pictureHeight = 0;     ///< pixels; for Spacing::Adaptive. 0: no pixel limits the slabs
    double displayStep = 0.0;            ///< radiance of the smallest step that the display shows, 0 or more.
                                         ///< plan() leaves out what is too faint to be seen: all omissions together
                                         ///< change a pixel by at most a quarter step. 0: nothing is left out
    bool everything = false;             ///< leaves nothing out, for comparison: draws every light over its whole
                                         ///< volume with every term. The slabs stay the same
};

/// What became of a light.
enum class Verdict : std::uint8_t {
    Drawn,
    Black,        ///< its colour is black
    NoDensity,    ///< its air scatters nothing
    NoStrength,   ///< neither intensity nor ambient
    ClipPlanes,   ///< its own clip planes leave nothing
    BehindEye,    ///< its volume lies behind the eye
    BeforeNear,   ///< its volume ends before the view's near plane
    BeyondFar,    ///< its volume begins beyond the view's far plane
    BehindScene,  ///< its volume begins behind View::sceneDepth
    BesideView,   ///< its volume misses the sides of the view's frustum
    BehindWalls,  ///< the part of its volume that the view shows lies behind blockers that stop all its light
    BehindTiles,  ///< surfaces hide its volume, by Surroundings::depth
    DarkCookie,   ///< its cookie is black in all of its seen volume
    NoDust,       ///< its noise is 0 everywhere, or its gain is 0
    Absorbed,     ///< its air absorbs all light between lamp and eye
    TooFaint,     ///< see PlanOptions::displayStep
};

/// Why a term is among those that a light is drawn with, or not.
enum class TermVerdict : std::uint8_t {
    NotAsked,    ///< the light does not ask for it
    Drawn,       ///< the light asks for it and the view needs it
    Forced,      ///< PlanOptions::terms or ::everything
    Overruled,   ///< PlanOptions::terms leave it out
    NoOccluder,  ///< shadow: nothing stands between the lamp and the air that is seen
    Uniform,     ///< cookie, noise, scattering: the same in all of the seen air; a factor replaces it
    Invisible,   ///< cookie, noise, scattering: differs by less than the display shows; its mean replaces it
};

/// Whether a term with this verdict is among those that the light is drawn with.
constexpr bool isDrawn(TermVerdict verdict) {
    return verdict == TermVerdict::Drawn || verdict == TermVerdict::Forced;
}

/// What becomes of one light. If `drawn` is false, it has no slices and no part; the other fields hold what was known
/// when planning of it ended.
struct PlannedLight {
    std::size_t light = 0;  ///< index into the lights that were given
    bool drawn = false;     ///< false: it adds nothing to this view
    Verdict verdict = Verdict::Drawn;
    PerTerm<TermVerdict> verdicts;  ///< why each term is in `terms`, or not
    TermSet terms;                  ///< of its part with the most terms
    Method method = Method::Slices;
    double brightest = 0.0;  ///< bound of the radiance that a pixel gets from it, in its strongest channel; infinite
                             ///< where unknown
    int slices = 0;          ///< number of slices that are drawn
    double nearDepth = 0.0, farDepth = 0.0;        ///< metres of view depth that the volume's slabs span, drawn or not
    double volumeNear = 0.0, volumeFar = 0.0;      ///< metres along the light's axis: the volume after its clip planes
    double seenNear = 0.0, seenFar = 0.0;          ///< the part of that range that the view can see
    double firstOccluder = 0.0;                    ///< with Term::Shadow: a lower bound, in metres along the axis: no
                                                   ///< occluder stands nearer to the lamp. The near plane if nothing is
                                                   ///< known, and with PlanOptions::everything or ::terms
    bool divided = false;                          ///< some of its slices are drawn without shadow
    std::uint32_t firstWall = 0, walls = 0;        ///< into Plan::walls: blockers that end its volume
    std::uint32_t firstIndex = 0, indexCount = 0;  ///< into Plan::indices; stretched quads are shared by lights
    std::size_t group = 0;                         ///< into Plan::groups
};

/// One draw: some of a light's indices with the technique of some terms, techniqueName(terms).
struct PlannedPart {
    Method method = Method::Slices;
    std::uint32_t light = 0;      ///< into Plan::lights
    std::uint32_t group = 0;      ///< into Plan::groups
    std::uint32_t constants = 0;  ///< into Plan::constants, or Plan::raycasts
    TermSet terms;
    std::uint32_t firstIndex = 0, indexCount = 0;  ///< into Plan::indices
    int slices = 0;
};

/// Lights that are added up in one target before it is composited. One group holds all lights, except in the routed
/// format: its four channels carry one grey value, so every chromaticity has its own group. The grey value is the
/// light's strongest channel times the luminance of its cookie: a coloured cookie keeps its pattern and takes the
/// light's colour.
struct CompositeGroup {
    glm::vec3 tint{1.0f};                    ///< multiplies the sum; routed, its largest component is 1
    std::uint32_t firstPart = 0, parts = 0;  ///< into Plan::parts
};

struct Plan {
    Geometry geometry = Geometry::ExactPolygons;
    Accumulation accumulation = Accumulation::Rgba16f;
    double scale = 1.0;  ///< target value = radiance * scale; compositing divides by it
    std::vector<SliceVertex> vertices;
    std::vector<std::uint32_t> indices;      ///< triangle list into `vertices`
    std::vector<SliceConstants> constants;   ///< the uniform blocks, which parts of a light may share
    std::vector<RaycastConstants> raycasts;  ///< those of lights with Method::Raycast
    std::vector<glm::dvec4> walls;           ///< view space, keep dot(n, p) + d >= 0: the lamp's light ends there
    std::vector<PlannedLight> lights;        ///< one for each light given, in their order
    std::vector<PlannedPart> parts;          ///< by group, and within it by technique, which minimizes pipeline changes
    std::vector<CompositeGroup> groups;      ///< empty if no light is drawn
};

/// Plans the shafts of `lights` as `view` sees them.
///
/// Slices are perpendicular to the view direction, at the midpoints of slabs that span the light's volume clamped
/// to the view's near plane, far plane and (Spacing::Even) scene depth. Within a part the farthest comes first. Slices
/// are convex, and counter-clockwise as the eye sees them. A slice without area has no triangles. Slices are cut off at
/// eight times the picture's half width. Slices that lie beside the picture, or hidden behind Surroundings::depth, are
/// left out.
///
/// With exact polygons a light with shadow is drawn in up to two parts (see PlannedLight::divided): one without the
/// shadow term, for the air that no occluder can shade, and one with it. The air behind blockers that cover the
/// light's whole pyramid is not drawn.
///
/// A plan a thousand kilometres from the world's origin is as accurate as one at the origin.
///
/// Errors: InvalidArgument where a value breaks the bounds stated in Light, View and PlanOptions, where
/// any of them is not finite (View::farPlane may be infinite), where the routed format meets a number of
/// slices that four does not divide, where stretched quads meet more than two extra clip planes, where lights times
/// slices exceed 2^24 (those that are drawn), where surveys or depth tiles do not have the stated number of entries,
/// where a tile's depth is negative or not a number, or where a light's strength or noise overflows the shader's
/// floats. Lights that would not be drawn are checked too.
Result<Plan> plan(std::span<const Light> lights, const View& view, const PlanOptions& options,
                  const Surroundings& surroundings = {});

/// How one light lights the surfaces that a view shows. A light without shafts, in air that scatters nothing, still
/// lights surfaces.
struct SurfaceLight {
    bool lit = false;               ///< it may light a surface in the picture
    bool shadow = false;            ///< an occluder may stand between it and such a surface: it needs its shadow map
    std::vector<glm::dvec4> walls;  ///< view space, keep dot(n, p) + d >= 0: no surface behind one is lit
};

/// plan() for frame after frame: reuses its working memory and the plan's, so it stops allocating once both have grown.
/// Not thread-safe.
class Planner {
public:
    Planner();
    Planner(Planner&&) noexcept;
    Planner& operator=(Planner&&) noexcept;
    ~Planner();

    /// Replaces the contents of `plan`. After an error, `plan` is empty.
    Result<void> plan(std::span<const Light> lights, const View& view, const PlanOptions& options,
                      const Surroundings& surroundings, Plan& plan);

    /// Writes into `needs` what the surfaces in the view need of each light, in the lights' order. Independent of
    /// cookie, noise and air. `shadowMapSize`: texels a side, see PlanOptions.
    ///
    /// Errors: those of plan() about lights, view and surroundings; `needs` is then empty.
    Result<void> surfaces(std::span<const Light> lights, const View& view, std::uint32_t shadowMapSize,
                          const Surroundings& surroundings, std::vector<SurfaceLight>& needs);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tyndall

// What a frame will draw, and why: pure CPU work in double precision, no Vulkan device.
#pragma once

#include <tyndall/light.h>
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
    Adaptive,  ///< as many as needed: a slab's thickness grows with its distance from the lamp, as do a cookie's
               ///< and a shadow map's texels, down to a pixel, or less in a narrow beam. They are counted from the
               ///< lamp's own depth, and the outermost end where the volume does: so nothing steps as eye or light
               ///< move. Look::Article, whose constants belong to equal slabs, keeps Even
};

struct PlanOptions {
    int slices = 100;  ///< a light, 1 to 65536; a multiple of 4 when routed. Adaptive: at most so many, or 2
    Spacing spacing = Spacing::Even;
    Geometry geometry = Geometry::ExactPolygons;
    Accumulation accumulation = Accumulation::Rgba16f;
    Look look = Look::Physical;
    double time = 0.0;                   ///< seconds; scrolls the noise
    double range = 1.0;                  ///< radiance that the value 1 of an 8-bit target stands for, > 0;
                                         ///< float targets hold radiance itself
    std::uint32_t shadowMapSize = 1024;  ///< texels a side, 1 to 65536, as the caller draws it
    double shadowBias = 0.0;             ///< metres along the light's axis, 0 to 1e9; more before blockers
                                         ///< that the map's texels are too coarse for; at most 0.99 of a light's
                                         ///< nearPlane takes effect, or points would fall behind the lamp
    std::optional<TermSet> terms;        ///< draws every light with these, whatever it calls for; a light
                                         ///< that lacks what its technique reads sees a neutral texture there
    std::uint32_t pictureHeight = 0;     ///< pixels; for Spacing::Adaptive. 0: as fine as the rest asks for
    double displayStep = 0.0;            ///< radiance of the smallest step that the display shows, 0 or more.
                                         ///< What is too faint to be seen is left out: at each pixel all that
                                         ///< is left out adds up to a quarter step at most. 0: nothing is
    bool everything = false;             ///< leaves nothing out, to compare with: every light is drawn over
                                         ///< its whole volume with every term. The slabs stay the same
};

/// What became of a light.
enum class Verdict : std::uint8_t {
    Drawn,
    Black,        ///< its colour is
    NoDensity,    ///< its air scatters nothing
    NoStrength,   ///< neither intensity nor ambient
    ClipPlanes,   ///< its own clip planes leave nothing
    BehindEye,    ///< its volume is
    BeforeNear,   ///< its volume ends before the view's near plane
    BeyondFar,    ///< its volume begins beyond the view's far plane
    BehindScene,  ///< its volume begins behind View::sceneDepth
    BesideView,   ///< its volume misses the sides of the view's frustum
    BehindWalls,  ///< what the view shows of its volume lies behind blockers that hold all its light up
    BehindTiles,  ///< surfaces hide its volume, by Surroundings::depth
    DarkCookie,   ///< its cookie is black wherever its volume is seen
    NoDust,       ///< its noise is 0 everywhere, or its gain
    Absorbed,     ///< its air absorbs all light on the way to what is seen and back to the eye
    TooFaint,     ///< see PlanOptions::displayStep
};

/// Why a term is among those that a light is drawn with, or not.
enum class TermVerdict : std::uint8_t {
    NotAsked,    ///< the light has none
    Drawn,       ///< called for
    Forced,      ///< PlanOptions::terms or ::everything
    Overruled,   ///< PlanOptions::terms leave it out
    NoOccluder,  ///< shadow: nothing stands between the lamp and the air that is seen
    Uniform,     ///< cookie, noise, scattering: the same wherever it is seen; a factor takes its place
    Invisible,   ///< cookie, noise, scattering: differs by less than the display shows; its mean takes its place
};

/// Whether a term with this verdict is among those that the light is drawn with.
constexpr bool isDrawn(TermVerdict verdict) {
    return verdict == TermVerdict::Drawn || verdict == TermVerdict::Forced;
}

/// What becomes of one light. Where `drawn` is false it has no slices and no part, and the rest is what was known
/// when the verdict fell.
struct PlannedLight {
    std::size_t light = 0;  ///< index into the lights that were given
    bool drawn = false;     ///< false: it adds nothing to this view
    Verdict verdict = Verdict::Drawn;
    PerTerm<TermVerdict> verdicts;  ///< why each term is in `terms`, or not
    TermSet terms;                  ///< of its fullest part
    double brightest = 0.0;  ///< no pixel gets more radiance from it, in its strongest channel; infinite where it
                             ///< was not asked for
    int slices = 0;          ///< that are drawn
    double nearDepth = 0.0, farDepth = 0.0;    ///< metres of view depth that the volume's slabs span, drawn or not
    double volumeNear = 0.0, volumeFar = 0.0;  ///< metres along the light's axis: all that its planes leave
    double seenNear = 0.0, seenFar = 0.0;      ///< of that, what the view can see
    double firstOccluder = 0.0;                ///< with Term::Shadow: metres along the axis before which none stands
    bool divided = false;                      ///< some of its slices are drawn without shadow
    std::uint32_t firstWall = 0, walls = 0;    ///< into Plan::walls: blockers that end its volume
    std::uint32_t firstIndex = 0, indexCount = 0;  ///< into Plan::indices; stretched quads are shared by lights
    std::size_t group = 0;                         ///< into Plan::groups
};

/// One draw: some of a light's indices with the technique of some terms, techniqueName(terms).
struct PlannedPart {
    std::uint32_t light = 0;      ///< into Plan::lights
    std::uint32_t group = 0;      ///< into Plan::groups
    std::uint32_t constants = 0;  ///< into Plan::constants
    TermSet terms;
    std::uint32_t firstIndex = 0, indexCount = 0;  ///< into Plan::indices
    int slices = 0;
};

/// Lights that are added up in one target before it is composited. One holds them all, except for the
/// routed format, whose four channels carry one grey value: there every chromaticity has its own. The grey
/// value is the light's strongest channel times the luminance of its cookie: a coloured cookie keeps its
/// pattern and takes the light's colour.
struct CompositeGroup {
    glm::vec3 tint{1.0f};                    ///< multiplies the sum; routed, its largest component is 1
    std::uint32_t firstPart = 0, parts = 0;  ///< into Plan::parts
};

struct Plan {
    Geometry geometry = Geometry::ExactPolygons;
    Accumulation accumulation = Accumulation::Rgba16f;
    double scale = 1.0;  ///< target value = radiance * scale; compositing divides by it
    std::vector<SliceVertex> vertices;
    std::vector<std::uint32_t> indices;     ///< triangle list into `vertices`
    std::vector<SliceConstants> constants;  ///< the uniform blocks, which parts of a light may share
    std::vector<glm::dvec4> walls;     ///< view space, keep dot(n, p) + d >= 0: behind one, no light of that lamp comes
    std::vector<PlannedLight> lights;  ///< one for each light given, in their order
    std::vector<PlannedPart> parts;    ///< by group, and within it by technique, so that pipelines change least
    std::vector<CompositeGroup> groups;  ///< none where no light is drawn
};

/// Plans the shafts of `lights` as `view` sees them.
///
/// Slices are perpendicular to the view direction, at the midpoints of slabs that span the light's volume clamped
/// to the view's near plane, far plane and (Spacing::Even) scene depth. They come farthest first within a part, are
/// convex and counter-clockwise as the eye sees them. A slice without area has no triangles. Far outside
/// the picture, at eight times its half width, slices are cut off; slices that lie beside the picture, or hidden
/// behind Surroundings::depth, are left out.
///
/// With exact polygons a light with shadow is drawn in two parts: what lies before the first occluder, or beside all
/// that occluders can shade, without looking its shadow up, the rest with it. What lies behind blockers that cover its
/// whole pyramid is not drawn.
///
/// The plan for lights and eye a thousand kilometres from the world's origin is as accurate as at it.
///
/// Errors: InvalidArgument where a value breaks the bounds stated in Light, View and PlanOptions, where
/// any of them is not finite (View::farPlane may be infinite), where the routed format meets a number of
/// slices that four does not divide, where stretched quads meet more than two extra clip planes, where lights times
/// slices exceed 2^24 (those that are drawn), where surveys or depth tiles do not have the stated number of entries,
/// where a tile's depth is negative or not a number, or where a light's strength or noise overflows the shader's floats.
/// Lights that would not be drawn are checked too.
Result<Plan> plan(std::span<const Light> lights, const View& view, const PlanOptions& options,
                  const Surroundings& surroundings = {});

/// How one light lights the surfaces that a view shows. Slices ask more of a light than surfaces do: air that scatters
/// nothing shows no shaft, and its lamp still lights the surfaces.
struct SurfaceLight {
    bool lit = false;               ///< it may light a surface in the picture
    bool shadow = false;            ///< an occluder may stand between it and such a surface: it needs its shadow map
    std::vector<glm::dvec4> walls;  ///< view space, keep dot(n, p) + d >= 0: no surface behind one is lit
};

/// plan() for frame after frame: keeps its working memory, and the plan's, so that once both have grown nothing is
/// allocated any more. Not thread-safe.
class Planner {
public:
    Planner();
    Planner(Planner&&) noexcept;
    Planner& operator=(Planner&&) noexcept;
    ~Planner();

    /// Writes the plan into `plan`, whatever it held before. Where it answers an error, `plan` is empty.
    Result<void> plan(std::span<const Light> lights, const View& view, const PlanOptions& options,
                      const Surroundings& surroundings, Plan& plan);

    /// Writes what the surfaces in the view need of each light into `needs`, one for each light in their order. Cookie,
    /// noise and the air change nothing of it. `shadowMapSize`: texels a side, as PlanOptions'.
    ///
    /// Errors: those of plan() about lights, view and surroundings; `needs` is empty then.
    Result<void> surfaces(std::span<const Light> lights, const View& view, std::uint32_t shadowMapSize,
                          const Surroundings& surroundings, std::vector<SurfaceLight>& needs);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tyndall

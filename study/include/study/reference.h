// The reference for pictures: the radiance of the light shafts at each pixel's centre,
//
//   L = density / (4 pi) * integral over the ray of
//       noise * cookie * shadow * phase * transmittance * (I / d^2 + ambient) dt,
//
//   phase = (1 - g^2) / (1 + g^2 - 2 g cos)^(3/2), cos = dot(lamp to particle, particle to eye),
//   transmittance = exp(-extinction * (distance lamp to particle + distance particle to eye)),
//
// in double precision, without slices. g is Light::anisotropy; extinction is density / Light::albedo, or 0 without
// an albedo, and is that of evenly filled air: noise does not change it. With parallel rays the path to the eye ends at
// depth 0. The reference shares no code with the renderer: it uses only the plain structs Light and View of plan/.
#pragma once

#include <study/image.h>
#include <tyndall/light.h>
#include <tyndall/result.h>
#include <tyndall/view.h>

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tyndall::study {

enum class Mode {
    Ideal,     ///< the world: shadows of the triangles themselves, surfaces where rays meet them
    Hardware,  ///< the renderer's own shadow maps and depth buffer, sampled as its shaders sample them
};

/// One corner after the other, world space, metres. Counter-clockwise as seen from its front.
struct Triangle {
    glm::dvec3 a, b, c;
    bool bothSides = false;  ///< hides the air behind it from both sides, not only from its front; every triangle
                             ///< throws a shadow
};

/// Half angles in radians: full light within `inner`, no light beyond `outer`, and the falloff of KHR_lights_punctual
/// between them. 0 <= inner <= outer < pi / 2.
struct Cone {
    double inner = 0.0, outer = 0.0;
};

/// Light::cookie, ::shadow and ::noise select a light's terms; textures of the others may be empty.
struct ReferenceLight {
    Light light;
    Image cookie;              ///< linear colour, three channels or more; bilinear, clamped
    std::optional<Cone> cone;  ///< multiplies the cookie, exactly; a renderer that bakes it into a texture has an error
    Image noise;               ///< red and green carry the two maps; bilinear, wrapped
    Image shadowMap;           ///< Hardware: square, one channel, stored depth as lightClipFromLight() projects it; the
                               ///< comparison comes first, then the bilinear filter, clamped
};

struct ReferenceScene {
    Mode mode = Mode::Ideal;
    View view;  ///< its sceneDepth is ignored
    int width = 0, height = 0;
    double time = 0.0;  ///< seconds; scrolls the noise
    std::vector<ReferenceLight> lights;
    std::vector<Triangle> triangles;  ///< Ideal
    Image depth;                      ///< Hardware: width x height, one channel, stored depth as view.clipFromView
                                      ///< projects it, with the far plane's value in empty pixels; may be empty
    double shadowBias = 0.0;          ///< Hardware: as PlanOptions::shadowBias
};

struct ReferenceOptions {
    double accuracy = 1e-8;  ///< maximum relative error at each pixel and channel; 1e-12 or more
    unsigned threads = 0;    ///< 0: one for each processor; the picture does not depend on it
    /// Called repeatedly on the calling thread with the share done, 0 to 1; false stops the work.
    std::function<bool(double)> progress;
};

struct ReferenceImage {
    int width = 0, height = 0;
    std::vector<glm::dvec3> radiance;  ///< rows from the top
    std::vector<double> bound;         ///< estimated bound of each pixel's relative error, in its worst channel
    double largestBound = 0.0;         ///< maximum over all pixels: the accuracy achieved
    std::uint64_t evaluations = 0;     ///< number of evaluations of the integrand
};

/// Errors, one sentence each: a light, view or texture that breaks a rule stated above; an image without pixels;
/// "interrupted" if `progress` returned false.
Result<ReferenceImage> reference(const ReferenceScene& scene, const ReferenceOptions& options = {});

}  // namespace tyndall::study

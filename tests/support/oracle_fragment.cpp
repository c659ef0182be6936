#include "oracle_fragment.h"

#include <cmath>
#include <numbers>

namespace tyndall::test {
namespace {

// Maximum error of an interpolated light-space position, in metres, with e = 2^-24.
//   Vertex shader: position, matrix entry, product and three sums, 6 e of the farthest vertex's distance from
//   the eye plus the lamp's; stretching a quad's vertex over the bounds, 4 e more. Times 1 / w and w: 4 e.
//   Rasterizer: a plane equation a0 + dadx x + dady y with dadx = (da1 dy2 - da2 dy1) / area2, the way
//   software and hardware set up triangles. With A the largest coordinate, a difference of two vertices
//   carries 2 * 2 e A from 1 / w and 2 e A of its own, 6 e A; a product 8 e A; two of them and their difference
//   18 e A L / area2, where L is the triangle's longest side and area2 twice its area. That times a distance of
//   up to X from the picture's corner, to a0 and back to the pixel, on both axes: 72 e A X L / area2.
double attributeErrorOf(const Shot& shot, double vertexDistance, double largestCoordinate) {
    return kFloatEps * (14.0 * vertexDistance + 72.0 * shot.triangleStretch * largestCoordinate);
}

// A vertex is snapped to 1/256 of a pixel (subPixelPrecisionBits 8), by 1/512 at most on either axis; its
// window coordinate before that has an error of at most another 1/512 if it is below 2^24 / (512 * 4) pixels, from four
// roundings. An edge moves at most as far as its ends.
constexpr double kEdgePixels = 1.0 / 512.0 + 1.0 / 512.0;

const Interval kOne = {1.0, 1.0};

// A sum or a product with constants, which the shader gets rounded to binary32.
Interval constant(double x) {
    return rounded(exactly(x));
}

struct LightPoint {
    Interval x, y, z, axis;  ///< light space, metres
    Interval u, v;           ///< of the projected picture, 0..1 from its top left corner
};

LightPoint project(const FragmentContext& context, glm::dvec3 viewPoint) {
    const Light& light = context.shot.light;
    const glm::dvec3 p(context.lightFromView * glm::dvec4(viewPoint, 1.0));
    const double error = context.attributeError;
    LightPoint point;
    point.x = around(p.x, error);
    point.y = around(p.y, error);
    point.z = around(p.z, error);
    point.axis = around(-p.z, error);
    // Image right is +X and image top +Y; the field of view spans the image. The shader interpolates the
    // numerators, so they have an error of their own, scaled like the position.
    const double sx = 0.5 / std::tan(0.5 * light.fov.x), sy = 0.5 / std::tan(0.5 * light.fov.y);
    const Interval right = around(sx * p.x - 0.5 * p.z, (sx + 0.5) * error);
    const Interval down = around(-sy * p.y - 0.5 * p.z, (sy + 0.5) * error);
    point.u = right / point.axis;
    point.v = down / point.axis;
    return point;
}

Interval drift(const FragmentContext& context, const LightPoint& point, int channel) {
    const Noise& noise = *context.shot.light.noise;
    const glm::dvec2 scroll = channel == 0 ? noise.scroll1 : noise.scroll2;
    const auto coordinate = [&](Interval t, double scale, double speed) {
        const double turns = speed * context.shot.time;
        const double phase = turns - std::floor(turns);
        // uv * scale + phase is interpolated times the axis: the numerator's error is that of uv scaled, plus
        // that of the axis times the phase, both over the axis again.
        const double error = (phase + 1.0) * context.attributeError / point.axis.lo;
        const Interval there = t * constant(scale) + constant(phase);
        return Interval{there.lo - error, there.hi + error};
    };
    return sampleLinear(context.shot.noiseMap, channel, Address::Wrap, coordinate(point.u, noise.scale.x, scroll.x),
                        coordinate(point.v, noise.scale.y, scroll.y));
}

Interval evenDust(const Shot& shot) {
    return constant(shot.article ? 0.015 : 1.0);
}

Interval dust(const FragmentContext& context, const LightPoint& point) {
    const Shot& shot = context.shot;
    if (!shot.light.noise) return evenDust(shot);
    const double gain = shot.article ? 0.05 : shot.light.noise->gain;
    return constant(gain) * drift(context, point, 0) * drift(context, point, 1);
}

// A texel lets the light through if its surface is as far from the lamp as the air, or farther. If rounding can change
// the comparison, the lower bound takes it as blocked and the upper bound as open.
Interval lightThrough(const FragmentContext& context, const LightPoint& point) {
    const Shot& shot = context.shot;
    const double n = shot.light.nearPlane, f = shot.light.farPlane;
    const Interval offset = constant(-n / (f - n)), slope = constant(n * f / (f - n));
    const Interval axis = point.axis - constant(shot.shadowBias);
    const Interval depth = axis.lo > 0.0 ? clamped(offset + slope / axis, 0.0, 0x1.fffffep-1) : Interval{0.0, 1.0};

    const Texture& map = shot.shadowMap;
    const auto open = [&](bool doubt) {
        return [&, doubt](int x, int y) {
            const double stored = map.at(x, y);
            if (stored <= depth.lo) return 1.0;
            if (stored > depth.hi) return 0.0;
            return doubt ? 1.0 : 0.0;
        };
    };
    // Texel coordinate: product, difference, fraction; then two lerps of numbers up to 1.
    const auto texels = [](Interval t, int size) { return t * exactly(size) + exactly(0.0) + exactly(0.0); };
    const Interval x = texels(point.u, map.width), y = texels(point.v, map.height);
    const Interval dark = bilinear(map.width, map.height, Address::Clamp, x, y, open(false));
    const Interval bright = bilinear(map.width, map.height, Address::Clamp, x, y, open(true));
    if (dark.lo == 1.0 && bright.hi == 1.0) return kOne;  // lerp(1, 1, t) and lerp(0, 0, t) are exact
    if (dark.hi == 0.0 && bright.hi == 0.0) return {0.0, 0.0};
    return clamped({dark.lo - 6.0 * kFloatEps, bright.hi + 6.0 * kFloatEps}, 0.0, 1.0);
}

Interval attenuation(const Shot& shot, const LightPoint& point) {
    // The published constants use inches; 1 inch is 0.0254 m exactly.
    const Interval units = constant(shot.article ? 1.0 / 0.0254 : 1.0);
    const Interval dd = square(point.x * units) + square(point.y * units) + square(point.z * units);
    return constant(shot.article ? 20000.0 : shot.light.intensity) / dd +
           constant(shot.article ? 0.25 : shot.light.ambient);
}

bool scatters(const Light& light) {
    return light.anisotropy != 0.0 || light.albedo.has_value();
}

// Light that a particle sends to the eye, relative to even scattering in clear air. The exact value comes from the law
// of cosines in the triangle of lamp, particle and eye. The interval comes from the rounding of each step of the
// shader's computation with unit vectors; e = 2^-24.
Interval scattered(const FragmentContext& context, glm::dvec3 viewPoint) {
    const Shot& shot = context.shot;
    const double g = shot.article ? 0.0 : shot.light.anisotropy;
    const double extinction = !shot.article && shot.light.albedo ? shot.light.density / *shot.light.albedo : 0.0;
    const glm::dvec3 lamp(glm::inverse(context.lightFromView)[3]);
    const double fromLamp = glm::distance(viewPoint, lamp), lampToEye = glm::length(lamp);
    const double toEye = shot.eye.orthographic ? -viewPoint.z : glm::length(viewPoint);
    // 1 - cos and 1 + cos of the angle by which light turns. With parallel rays the direction to the eye is the view
    // axis, and the path along it is the difference of view depths.
    double minus, plus;
    if (shot.eye.orthographic) {
        const double back = viewPoint.z - lamp.z;
        minus = (fromLamp - back) / fromLamp;
        plus = (fromLamp + back) / fromLamp;
    } else {
        const double twice = 2.0 * fromLamp * toEye;
        minus = ((fromLamp + toEye) * (fromLamp + toEye) - lampToEye * lampToEye) / twice;
        plus = (lampToEye * lampToEye - (fromLamp - toEye) * (fromLamp - toEye)) / twice;
    }
    const double turned = std::clamp(g < 0.0 ? plus : minus, 0.0, 2.0);

    // The interpolated position has the attribute's error; the difference from the eye has that, the eye's rounding and
    // its own. A unit vector adds a dot product (4 e, halved by the root), the root (4 e) and a product; their
    // difference e of up to 2.
    const double e = kFloatEps, error = context.attributeError * std::sqrt(3.0);
    const double eyeError = shot.eye.orthographic ? 0.0 : error + 2.0 * e * (lampToEye + fromLamp);
    const double chord = std::sqrt(2.0 * turned);
    const double chordError =
        error / fromLamp + (shot.eye.orthographic ? 2.0 * e : eyeError / toEye) + 2.0 * 8.0 * e + 2.0 * e;
    const double strength = std::abs(g), narrow = 1.0 - strength;
    const auto baseAt = [&](double c) { return narrow * narrow + strength * c * c; };
    // 2 e for 1 - |g|, a product each, e for |g|, 4 e for the dot product, a sum: 8 e of a sum of positive terms.
    const Interval base = rounded({baseAt(std::max(0.0, chord - chordError)), baseAt(chord + chordError)}, 8.0);
    const Interval phase = constant(narrow) / base * (rounded(exactly(1.0 + strength), 2.0) / squareRoot(base));

    // Parallel rays: a dot product, and a difference of lengths up to the lamp's depth and its path.
    const double wayError =
        error + 8.0 * e * fromLamp +
        (shot.eye.orthographic ? error + 8.0 * e * (std::abs(lamp.z) + fromLamp) : eyeError + 8.0 * e * toEye);
    const Interval way = rounded(around(fromLamp + toEye, wayError));
    const Interval argument = constant(extinction) * way;
    // the error of exp is up to 3 + 2 |x| ulp (Vulkan, "Precision and Operation of SPIR-V Instructions").
    const Interval left =
        rounded({std::exp(-argument.hi), std::exp(-std::max(argument.lo, 0.0))}, 6.0 + 4.0 * argument.hi);
    return phase * left;
}

// Metres of ray in the slab: its thickness times the ray's length for one metre of depth.
Interval slabLength(const FragmentContext& context, glm::dvec3 perMetre, double depth) {
    const Shot& shot = context.shot;
    if (shot.article) return constant(9.0 / (shot.slices / 100.0));
    // Both ends of the extent are binary32, and the attribute itself adds 4 e.
    const double thickness = context.slabThickness;
    const double endError = 2.0 * kFloatEps * (depth + thickness * shot.slices);
    const Interval length = rounded(around(thickness, endError / shot.slices), 4.0);
    if (shot.eye.orthographic) return length;
    const double rayError = context.attributeError / depth;
    const Interval squared = square(around(perMetre.x, rayError)) + square(around(perMetre.y, rayError)) +
                             square(around(perMetre.z, rayError));
    return length * squareRoot(squared);
}

}  // namespace

FragmentContext fragmentContext(const Shot& shot, const std::vector<HalfSpace>& volume,
                                const std::vector<glm::dvec3>& corners, double slabThickness) {
    const glm::dmat4 lightFromView = glm::inverse(shot.light.worldFromLight) * shot.eye.worldFromView;
    // A quad is cut from the box around the volume; the box's corners are farther away than the volume's.
    glm::dvec3 reach(0.0);
    double farthest = 0.0, largestCoordinate = 0.0;
    for (const glm::dvec3& p : corners) {
        reach = glm::max(reach, glm::abs(p));
        farthest = std::max(farthest, glm::length(p));
        largestCoordinate = std::max(largestCoordinate, glm::length(glm::dvec3(lightFromView * glm::dvec4(p, 1.0))));
    }
    const double lamp = glm::length(glm::dvec3(lightFromView[3]));
    if (shot.quads) {
        farthest = glm::length(reach);
        largestCoordinate = farthest + lamp;
    }
    const double error = attributeErrorOf(shot, farthest + lamp, largestCoordinate);
    return {shot, volume, lightFromView, slabThickness, error, kEdgePixels};
}

Ray pixelRay(const Shot& shot, double pixelX, double pixelY) {
    const double aspect = static_cast<double>(shot.width) / shot.height;
    const double right = (2.0 * pixelX / shot.width - 1.0) * aspect, up = 1.0 - 2.0 * pixelY / shot.height;
    if (shot.eye.orthographic) return {glm::dvec3(right, up, 0.0) * shot.eye.halfHeight, glm::dvec3(0.0, 0.0, -1.0)};
    const double t = std::tan(0.5 * shot.eye.verticalFov);
    return {glm::dvec3(0.0), glm::dvec3(right * t, up * t, -1.0)};
}

double storedSceneDepth(const Eye& eye, double depth) {
    const double n = eye.nearPlane, f = eye.farPlane;
    if (eye.orthographic) return (f - depth) / (f - n);
    if (std::isinf(f)) return n / depth;
    return n * (f - depth) / (depth * (f - n));
}

double storedShadowDepth(const Light& light, double axis) {
    const double n = light.nearPlane, f = light.farPlane;
    return n * (f - axis) / (axis * (f - n));
}

Seen coverage(const FragmentContext& context, int x, int y, double depth) {
    const Shot& shot = context.shot;
    const auto pointAt = [&](double px, double py) {
        const Ray ray = pixelRay(shot, px, py);
        return ray.origin + ray.perMetre * depth;
    };
    const glm::dvec3 p = pointAt(x + 0.5, y + 0.5);
    const glm::dvec3 alongX = pointAt(x + 1.5, y + 0.5) - p, alongY = pointAt(x + 0.5, y + 1.5) - p;

    Seen seen = Seen::Yes;
    for (const HalfSpace& plane : context.volume) {
        // Metres by which the distance changes within the uncertainty of an edge, and the attributes' own.
        const double slack =
            context.edgePixels * (std::abs(glm::dot(plane.normal, alongX)) + std::abs(glm::dot(plane.normal, alongY))) +
            context.attributeError;
        const double distance = plane.distance(p);
        if (distance < -slack) return Seen::No;
        if (distance < slack) seen = Seen::Maybe;
    }
    if (!shot.sceneDepth.texels.empty()) {
        // The clip-space z is a sum of two products over w; its plane equation errs like any attribute's.
        const double stored = storedSceneDepth(shot.eye, depth);
        const double near = shot.eye.nearPlane;
        const double terms = near / shot.eye.farPlane + (shot.eye.orthographic ? 1.0 : near / depth);
        const double slack = kFloatEps * (16.0 * terms + 72.0 * shot.triangleStretch * stored);
        const double surface = shot.sceneDepth.at(x, y);
        if (stored + slack < surface) return Seen::No;
        if (stored - slack < surface) seen = Seen::Maybe;
    }
    return seen;
}

Masks masks(const FragmentContext& context, int x, int y, double depth) {
    const Shot& shot = context.shot;
    const Ray ray = pixelRay(shot, x + 0.5, y + 0.5);
    const LightPoint point = project(context, ray.origin + ray.perMetre * depth);
    Masks masks{kOne, kOne, kOne, {kOne, kOne, kOne}};
    if (scatters(shot.light)) masks.scattering = scattered(context, ray.origin + ray.perMetre * depth);
    if (shot.light.noise) masks.noise = dust(context, point) / evenDust(shot);
    if (shot.light.shadow) masks.shadow = lightThrough(context, point);
    if (shot.light.cookie)
        for (int c = 0; c < 3; ++c) masks.cookie[c] = sampleLinear(shot.cookieMap, c, Address::Clamp, point.u, point.v);
    return masks;
}

std::array<Interval, 4> radiance(const FragmentContext& context, int x, int y, double depth) {
    const Shot& shot = context.shot;
    const Ray ray = pixelRay(shot, x + 0.5, y + 0.5);
    const LightPoint point = project(context, ray.origin + ray.perMetre * depth);

    Interval intensity = dust(context, point) * attenuation(shot, point) * slabLength(context, ray.perMetre, depth);
    if (scatters(shot.light)) intensity = intensity * scattered(context, ray.origin + ray.perMetre * depth);
    if (shot.light.shadow) intensity = intensity * lightThrough(context, point);

    const double scatter = shot.article ? 1.0 : shot.light.density / (4.0 * std::numbers::pi);
    // One grey value represents the light's brightest channel; the tint scales the others down again.
    const glm::dvec3 own = shot.light.colour;
    const glm::dvec3 lamp = shot.routed ? glm::dvec3(std::max({own.r, own.g, own.b})) : own;
    std::array<Interval, 4> out{};
    for (int c = 0; c < 3; ++c) {
        Interval colour = constant(lamp[c] * scatter);
        if (shot.light.cookie) colour = colour * sampleLinear(shot.cookieMap, c, Address::Clamp, point.u, point.v);
        out[c] = rounded(colour * intensity, 8.0);  // scale, mask and their interpolation
    }
    // Rec. 709 luminance of linear light.
    out[3] = out[0] * constant(0.2126) + out[1] * constant(0.7152) + out[2] * constant(0.0722);
    return out;
}

}  // namespace tyndall::test

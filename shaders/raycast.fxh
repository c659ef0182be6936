// Volumetric light shafts, one ray for each pixel: the integral that slices.fx sums up, exact to the texel.
//
//   L = density / (4 pi) * integral over the ray of
//       noise * cookie * shadow * phase * transmittance * (I / d^2 + ambient) dt
//
// Light space has the lamp at the origin, looks along -Z with +Y up. Let w be the distance along the axis. A point's
// *slope* is (x / w, y / w): where it lies on a slide one metre before the lamp. A view ray between the depths a and b
// draws a straight line on that slide. With lambda from 0 to 1 along that line,
//
//   slope = slope_a + lambda * (slope_b - slope_a),   1 / w = 1 / w_a + lambda * (1 / w_b - 1 / w_a)
//   dt / d^2 = K dlambda / (1 + |slope|^2),   dt = K dlambda * w^2,   K = (t_b - t_a) / (w_a * w_b)
//
// Lambda 0 is the end that is farther from the lamp's plane: 1 / w is smallest there, and floats are finest near 0.
//
// So texels of cookie, noise and shadow map begin and end at values of lambda that are linear in the ray's constants,
// and the integrand has no peak: the inverse square law is in K. Between two borders the integrand is smooth, and two
// Gauss points integrate it.
//
// Shadow: a texel of stored depth z lights the ray up to one value of lambda. The map is compared before it is filtered,
// so the four texels of a cell each count with their bilinear weight up to their own border. Blocks of cells that are
// all lit or all dark are passed in one step: the shadow hierarchy (shadow_hierarchy.fx) says which. Skipping what adds
// nothing is the stopping criterion of J. Krueger and R. Westermann, "Acceleration Techniques for GPU-based Volume
// Rendering" (IEEE Visualization 2003).

#include "integrals.fxh"
#include "precise.fxh"
#include "scattering.fxh"

// The ray of a pixel at clip coordinates (x, y): origin = [0] + x [1] + y [2], in light space, at the lamp's own view
// depth gPixel.z: from a far eye floats would lose the air about the lamp. w: of the clip-space depth, see gSurface.
float4 gOrigin[3];
float4 gDirection[3];    // the same, for each metre of view depth
float4 gPlanes[18];      // light space, keep dot(n, p) + d >= 0
float4 gVolume;          // xy: tan(fov / 2), zw: near and far plane along the light's axis
float4 gDepths;          // xy: view depths between which air is seen, z: how many of gPlanes are used, w: top level of
                         // the shadow hierarchy, as cells a side
float4 gSurface;         // stored depth * (x + y * depth) = gOrigin.w + gDirection.w * depth; z: 1 = read it
float4 gPixel;           // xy: width and height of a pixel in clip coordinates, z: view depth of gOrigin
float4 gTexels;          // xy: size of the cookie in texels, zw: of the noise
float4 gCookieScale;     // xy: 0.5 / tan(fov / 2), horizontal and vertical
float4 gAttenuation;     // x: I in candela, y: ambient in cd/m^2, z: light units per metre
float4 gDust;            // x: factor without noise, y: gain of the noise product
float4 gNoise1;          // xy: repeats over the field of view, zw: phase in [0, 1)
float4 gNoise2;
float4 gColour;          // rgb: light colour * density / (4 pi) * target scale, w: 1 = one grey value
float4 gWeight;          // x: factor, y: 1 = metres along the ray count, 0 = metres of view depth
float4 gShadow;          // stored depth = x + y / w; z: map size in texels, w: bias in metres
float4 gScattering;      // x: anisotropy g, y: extinction in 1/m, z: 1 - |g|
float4 gChannels;        // multiplies the result: a routed target's share of each channel

sampler2D CookieSampler = sampler_state
{
    MinFilter = LINEAR; MagFilter = LINEAR; MipFilter = NONE;
    AddressU = CLAMP; AddressV = CLAMP;
};
sampler2D ScrollingNoiseSampler = sampler_state
{
    MinFilter = LINEAR; MagFilter = LINEAR; MipFilter = NONE;
    AddressU = WRAP; AddressV = WRAP;
};
sampler2D ShadowMapSampler = sampler_state  // reversed depth: 1 at the light's near plane, 0 at its far plane
{
    MinFilter = POINT; MagFilter = POINT; MipFilter = NONE;
    AddressU = CLAMP; AddressV = CLAMP;
};
sampler2D ShadowHierarchySampler = sampler_state  // level n: minimum and maximum over blocks of 2^(n+1) cells a side
{
    MinFilter = POINT; MagFilter = POINT; MipFilter = POINT;
    AddressU = CLAMP; AddressV = CLAMP;
};
sampler2D SceneDepthSampler = sampler_state
{
    MinFilter = POINT; MagFilter = POINT; MipFilter = NONE;
    AddressU = CLAMP; AddressV = CLAMP;
};

static const float gaussNode = 0.577350269;  // 1 / sqrt(3)
// Largest angle, seen from the lamp, of one step: two Gauss points then integrate 1 / (1 + |slope|^2) to 2e-5.
static const float longestArc = 0.25;
// No step is shorter than this share of the ray: textures with more texels than that are sampled.
static const float shortestStep = 6.1e-5;

// The part of a view ray in the light's volume, over lambda from 0 to 1.
struct Ray
{
    float2 slope, slopeRate;
    float  inverse, inverseRate;  // 1 / w, which grows
    float  arcRate;               // d(angle seen from the lamp) / dlambda = arcRate / (1 + |slope|^2)
    float  scale;                 // K, per metre of view depth
    float  depth;                 // view depth at lambda 0
    float  towards;               // 1: view depth grows with lambda, -1: it falls
    float  slant;                 // metres of ray for each metre of view depth
    float3 toEye;                 // unit vector
};

float inverse_axis(Ray ray, float lambda)
{
    return ray.inverse + lambda * ray.inverseRate;
}

float2 slide(Ray ray, float lambda)
{
    return 0.5 + (ray.slope + lambda * ray.slopeRate) * float2(gCookieScale.x, -gCookieScale.y);
}

// Cuts the range of t where value + t * rate < 0.
void cut(float value, float rate, inout float2 range)
{
    float t = -value / rate;
    if (rate > 0.0)
        range.x = max(range.x, t);
    else if (rate < 0.0)
        range.y = min(range.y, t);
    else if (value < 0.0)
        range.y = range.x;
}

// phase * transmittance, see scattering.fxh and slices.fx.
float scattered(Ray ray, float2 slope, float lambda)
{
    float inverse = inverse_axis(ray, lambda);
    float3 fromLamp = float3(slope, -1.0);
    float lampDistance = length(fromLamp) / inverse;
    float eyeDistance = ray.slant * (ray.depth + ray.towards * ray.scale * lambda / (ray.inverse * inverse));
    return phase(unit(fromLamp), ray.toEye, gScattering.x, gScattering.z) *
           exp(-gScattering.y * (lampDistance + eyeDistance));
}

// noise * cookie * phase * transmittance.
float3 mask(Ray ray, float lambda, bool noise, bool cookie, bool scattering)
{
    float2 uv = slide(ray, lambda);
    float3 value = float3(1.0, 1.0, 1.0);
    if (cookie)
    {
        value = tex2Dlod(CookieSampler, float4(uv, 0.0, 0.0)).rgb;
        if (dot(value, value) == 0.0)
            return value;
    }
    if (noise)
    {
        // One texture carries both maps; they drift over each other.
        float noise1 = tex2Dlod(ScrollingNoiseSampler, float4(uv * gNoise1.xy + gNoise1.zw, 0.0, 0.0)).r;
        float noise2 = tex2Dlod(ScrollingNoiseSampler, float4(uv * gNoise2.xy + gNoise2.zw, 0.0, 0.0)).g;
        value *= gDust.y * noise1 * noise2;
    }
    if (scattering)
        value *= scattered(ray, ray.slope + lambda * ray.slopeRate, lambda);
    return value;
}

// Lambda of the next border between texels, of a texture whose coordinate in texels is `x` here and changes by `rate`
// for each unit of lambda. A border closer than the tolerance counts as passed: the integrand is continuous there.
float next_border(float x, float rate, float lambda)
{
    float tolerance = max(1e-3, 2.4e-7 * abs(rate));
    float border = rate > 0.0 ? floor(x + tolerance) + 1.0 : ceil(x - tolerance) - 1.0;
    return rate == 0.0 ? 2.0 : lambda + (border - x) / rate;
}

// The same in both directions of a texture of `size` texels at `uv`, which changes by `rate`.
float next_texel(float2 uv, float2 rate, float2 size, float lambda)
{
    float2 x = uv * size - 0.5;
    return min(next_border(x.x, rate.x * size.x, lambda), next_border(x.y, rate.y * size.y, lambda));
}

// Where the integrand stops being smooth, or changes more than two Gauss points can follow.
float step_end(Ray ray, float lambda, bool noise, bool cookie, bool scattering)
{
    float2 uv = slide(ray, lambda);
    float2 rate = ray.slopeRate * float2(gCookieScale.x, -gCookieScale.y);
    float2 slope = ray.slope + lambda * ray.slopeRate;
    float squared = 1.0 + dot(slope, slope);
    float arc = longestArc;
    if (scattering)
        arc = min(arc, 0.3 * gScattering.z);  // the width of the phase function's peak
    float end = lambda + arc * squared / max(ray.arcRate, 1e-30);
    bool extinction = scattering && gScattering.y > 0.0;
    if (cookie)
        end = min(end, next_texel(uv, rate, gTexels.xy, lambda));
    if (noise)
    {
        end = min(end, next_texel(uv * gNoise1.xy + gNoise1.zw, rate * gNoise1.xy, gTexels.zw, lambda));
        end = min(end, next_texel(uv * gNoise2.xy + gNoise2.zw, rate * gNoise2.xy, gTexels.zw, lambda));
    }
    end = max(end, lambda + shortestStep);
    if (gAttenuation.y > 0.0 || extinction)
    {
        // dt / dlambda is w^2: a third of the distance to the lamp's plane, and a quarter of an optical depth. Where an
        // optical depth is a small part of that distance, some fifty of them lie before the lamp, and no light is left.
        float inverse = inverse_axis(ray, lambda);
        float third = 0.3 * inverse / max(ray.inverseRate, 1e-30);
        end = min(end, lambda + third);
        float quarter = 0.25 * inverse * inverse / (gScattering.y * ray.slant * ray.scale);
        if (extinction)
            end = min(end, lambda + max(quarter, min(0.02 * third, shortestStep)));
    }
    return end;
}

// A bilinear weight along the ray: (x + lambda y) (z + lambda w), each factor within 0 and 1.
float weight_at(float4 window, float lambda)
{
    float2 sides = saturate(window.xz + lambda * window.yw);
    return sides.x * sides.y;
}

// A stretch of the ray that one weight lights. What is before `at` is added up already.
struct Stretch
{
    float  at, end;
    float4 window;  // see weight_at()
    bool   whole;   // the weight is 1
};

// The integral of weight * mask * (I / (1 + |slope|^2) + ambient * w^2) over the stretch's next step.
float3 step_on(Ray ray, inout Stretch stretch, bool noise, bool cookie, bool scattering)
{
    float light = gAttenuation.x / (gAttenuation.z * gAttenuation.z);
    float ambient = gAttenuation.y;
    float first = stretch.at, last = stretch.end;
    if (stretch.whole && !noise && !cookie && !scattering)
    {
        stretch.at = last;
        float2 from = ray.slope + first * ray.slopeRate, to = ray.slope + last * ray.slopeRate;
        float extent = last - first;
        float value = light * extent * arc_over_side(ray.arcRate * extent, 1.0 + dot(from, to)) +
                      ambient * extent / (inverse_axis(ray, first) * inverse_axis(ray, last));
        return float3(value, value, value);
    }
    last = min(last, step_end(ray, first, noise, cookie, scattering));
    stretch.at = last;
    float extent = last - first;
    float2 at = 0.5 * (first + last) + 0.5 * gaussNode * extent * float2(-1.0, 1.0);
    float2 slope1 = ray.slope + at.x * ray.slopeRate, slope2 = ray.slope + at.y * ray.slopeRate;
    float2 strength = light / float2(1.0 + dot(slope1, slope1), 1.0 + dot(slope2, slope2));
    if (ambient > 0.0)
    {
        // w^2 may change by any factor: its integral over the step is exact, divided as the two points have it.
        float2 inverse = float2(inverse_axis(ray, at.x), inverse_axis(ray, at.y));
        float2 square = 1.0 / (inverse * inverse);
        float mean = 1.0 / (inverse_axis(ray, first) * inverse_axis(ray, last));
        strength += ambient * mean * square / (0.5 * (square.x + square.y));
    }
    return 0.5 * extent * (strength.x * weight_at(stretch.window, at.x) * mask(ray, at.x, noise, cookie, scattering) +
                           strength.y * weight_at(stretch.window, at.y) * mask(ray, at.y, noise, cookie, scattering));
}

// What the shadow map would have to store to block the light exactly here. Clamped as slices.fx clamps it: a map filled
// with 1 blocks everything, an empty map (all 0) nothing.
float depth_at(Ray ray, float lambda)
{
    float inverse = inverse_axis(ray, lambda);
    return clamp(gShadow.x + gShadow.y * inverse / (1.0 - gShadow.w * inverse), 0.0, 0.99999994);
}

// The part of [first, last] that a texel of this stored depth lights.
float2 lit_part(Ray ray, float stored, float first, float last)
{
    float2 part = float2(first, last);
    if (stored <= 0.0)
        return part;
    if (stored > 0.99999994)
        return float2(first, first);
    float above = stored - gShadow.x;
    float inverse = above / (gShadow.y + gShadow.w * above);
    if (ray.inverseRate == 0.0)
        return depth_at(ray, first) >= stored ? part : float2(first, first);
    return float2(clamp((inverse - ray.inverse) / ray.inverseRate, first, last), last);
}

// A walk over the cells of the shadow map: cell (i, j) lies between the centres of the texels i, i + 1 and j, j + 1.
// Those at the border, from -1 to size - 1, are cut in half by it; both of their texels are the outermost.
struct Walk
{
    float2 origin, rate;   // the ray's place in texels: origin + lambda * rate
    float2 cell;
    float  side, level;    // of the current block: 1, 2, 4, ... cells a side, and its level in the hierarchy
    float  lambda;
    float  litFrom;        // where the lit stretch that ends here began; negative in the dark
    bool   done;
    // The stretches found last: number 0 is the lit air before `first`, 1 to 4 are a cell's texels from `first` to `last`.
    int    next, lastFound;
    float  first, last;
    float2 found;          // that cell
    float4 stored;         // its texels
};

Walk walk_along(Ray ray)
{
    Walk walk;
    float size = gShadow.z;
    float2 scale = float2(gCookieScale.x, -gCookieScale.y) * size;
    walk.origin = 0.5 * size - 0.5 + ray.slope * scale;
    walk.rate = ray.slopeRate * scale;
    walk.cell = clamp(floor(walk.origin), -1.0, size - 1.0);
    walk.side = gDepths.w;
    walk.level = log2(walk.side) - 1.0;
    walk.lambda = 0.0;
    walk.litFrom = -1.0;
    walk.done = false;
    walk.next = 1;
    walk.lastFound = 0;
    walk.first = walk.last = 0.0;
    walk.found = walk.cell;
    walk.stored = float4(0.0, 0.0, 0.0, 0.0);
    return walk;
}

// Passes the current block, or goes down to a smaller one.
void walk_on(Ray ray, inout Walk walk)
{
    float lastCell = gShadow.z - 1.0;
    float2 block = floor(walk.cell / walk.side);
    float2 edge = walk.side * float2(walk.rate.x > 0.0 ? block.x + 1.0 : block.x,
                                     walk.rate.y > 0.0 ? block.y + 1.0 : block.y);
    bool openX = walk.rate.x > 0.0 ? edge.x <= lastCell : walk.rate.x < 0.0 && edge.x > -1.0;
    bool openY = walk.rate.y > 0.0 ? edge.y <= lastCell : walk.rate.y < 0.0 && edge.y > -1.0;
    float exitX = openX ? (edge.x - walk.origin.x) / walk.rate.x : 2.0;
    float exitY = openY ? (edge.y - walk.origin.y) / walk.rate.y : 2.0;
    float exit = clamp(min(exitX, exitY), walk.lambda, 1.0);

    float here = depth_at(ray, walk.lambda), there = depth_at(ray, exit);
    float4 stored = float4(0.0, 0.0, 0.0, 0.0);
    float2 bounds;
    if (walk.side > 1.0)
    {
        float2 uv = (block + 0.5) * walk.side / gDepths.w;
        bounds = tex2Dlod(ShadowHierarchySampler, float4(uv, 0.0, walk.level)).rg;
    }
    else
    {
        float2 uv00 = (walk.cell + 0.5) / gShadow.z, uv11 = (walk.cell + 1.5) / gShadow.z;
        stored.x = tex2Dlod(ShadowMapSampler, float4(uv00, 0.0, 0.0)).r;
        stored.y = tex2Dlod(ShadowMapSampler, float4(uv11.x, uv00.y, 0.0, 0.0)).r;
        stored.z = tex2Dlod(ShadowMapSampler, float4(uv00.x, uv11.y, 0.0, 0.0)).r;
        stored.w = tex2Dlod(ShadowMapSampler, float4(uv11, 0.0, 0.0)).r;
        bounds = float2(min(min(stored.x, stored.y), min(stored.z, stored.w)),
                        max(max(stored.x, stored.y), max(stored.z, stored.w)));
    }
    bool lit = min(here, there) >= bounds.y;
    bool dark = max(here, there) < bounds.x;
    if (!lit && !dark && walk.side > 1.0)
    {
        walk.side *= 0.5;
        walk.level -= 1.0;
        return;
    }

    walk.done = !(exit < 1.0);  // also where it is no number
    if (lit && walk.litFrom < 0.0)
        walk.litFrom = walk.lambda;
    if (!lit || walk.done)
    {
        walk.next = walk.litFrom < 0.0 ? 1 : 0;
        walk.lastFound = lit || dark ? 0 : 4;
        walk.first = lit ? exit : walk.lambda;
        walk.last = exit;
        walk.found = walk.cell;
        walk.stored = stored;
    }

    // To the next block, and up one level where blocks of both levels end here.
    float2 at = clamp(floor(walk.origin + exit * walk.rate), block * walk.side, block * walk.side + (walk.side - 1.0));
    bool x = exitX <= exitY;
    float2 cell = float2(x ? (walk.rate.x > 0.0 ? edge.x : edge.x - 1.0) : at.x,
                         x ? at.y : (walk.rate.y > 0.0 ? edge.y : edge.y - 1.0));
    walk.cell = clamp(cell, -1.0, lastCell);
    walk.lambda = exit;
    float crossed = (x ? edge.x : edge.y) / (2.0 * walk.side);
    if (walk.side < gDepths.w && floor(crossed) == crossed)
    {
        walk.side *= 2.0;
        walk.level += 1.0;
    }
}

// The next of the stretches that the walk has found.
Stretch take_stretch(Ray ray, inout Walk walk)
{
    Stretch stretch;
    int number = walk.next;
    walk.next = number + 1;
    stretch.whole = number == 0;
    stretch.window = float4(1.0, 0.0, 1.0, 0.0);
    float2 part = float2(walk.litFrom, walk.first);
    if (number == 0)
    {
        walk.litFrom = -1.0;
    }
    else
    {
        bool right = number == 2 || number == 4, below = number > 2;
        float stored = number == 1 ? walk.stored.x : number == 2 ? walk.stored.y :
                       number == 3 ? walk.stored.z : walk.stored.w;
        part = lit_part(ray, stored, walk.first, walk.last);
        float2 from = walk.origin - walk.found;
        stretch.window = float4(right ? from.x : 1.0 - from.x, right ? walk.rate.x : -walk.rate.x,
                                below ? from.y : 1.0 - from.y, below ? walk.rate.y : -walk.rate.y);
    }
    stretch.at = part.x;
    stretch.end = part.y;
    return stretch;
}

// The integral over the ray's lit air. One loop for the walk and the integration: pixels that are drawn together then
// integrate together, though their lit stretches begin and end at different steps of their walks.
float3 lit_air(Ray ray, bool noise, bool shadow, bool cookie, bool scattering)
{
    float3 sum = float3(0.0, 0.0, 0.0);
    Stretch stretch;
    stretch.at = 0.0;
    stretch.end = shadow ? 0.0 : 1.0;
    stretch.window = float4(1.0, 0.0, 1.0, 0.0);
    stretch.whole = true;
    Walk walk = walk_along(ray);
    walk.done = !shadow;
    bool more = true;
    [loop] while (more)
    {
        if (shadow && !(stretch.at < stretch.end))
        {
            if (walk.next <= walk.lastFound)
                stretch = take_stretch(ray, walk);
            else if (!walk.done)
                walk_on(ray, walk);
        }
        bool lit = stretch.at < stretch.end;
        if (lit)
            sum += step_on(ray, stretch, noise, cookie, scattering);
        more = lit || walk.next <= walk.lastFound || !walk.done;
    }
    return sum;
}

// The view depth of the scene's surface at clip coordinates `clip`.
float surface_depth(float2 clip, float origin, float direction)
{
    float stored = tex2Dlod(SceneDepthSampler, float4(0.5 * clip + 0.5, 0.0, 0.0)).r;
    float rate = gSurface.y * stored - direction;
    float depth = (origin - gSurface.x * stored) / rate;
    // At infinity, or behind: nothing ends the ray.
    return depth > 0.0 ? depth : 1e30;
}

// What the light adds to the pixel of that number.
float4 radiance_of(float2 pixel, bool noise, bool shadow, bool cookie, bool scattering)
{
    // From the pixel's number: an interpolator would be off by a thousandth of a pixel in a narrow polygon.
    float2 clip = (pixel + 0.5) * gPixel.xy - 1.0;
    float4 origin = gOrigin[0] + clip.x * gOrigin[1] + clip.y * gOrigin[2];
    float4 direction = gDirection[0] + clip.x * gDirection[1] + clip.y * gDirection[2];

    // The point of the ray that is nearest to the lamp: depths count from there, so that nothing cancels beside the
    // lamp, however far the eye is.
    float3 moment = precise_cross(origin.xyz, direction.xyz);
    float squared = dot(direction.xyz, direction.xyz);
    float3 foot = cross(direction.xyz, moment) / squared;
    float footDepth = -dot(origin.xyz, direction.xyz) / squared;  // from gPixel.z

    float end = gDepths.y;
    if (gSurface.z > 0.0)
        end = min(end, surface_depth(clip, origin.w, direction.w));
    float2 range = (float2(gDepths.x, end) - gPixel.z) - footDepth;

    float axis = -foot.z, axisRate = -direction.z;
    cut(axis - gVolume.z, axisRate, range);
    cut(gVolume.w - axis, -axisRate, range);
    cut(gVolume.x * axis - foot.x, gVolume.x * axisRate - direction.x, range);
    cut(gVolume.x * axis + foot.x, gVolume.x * axisRate + direction.x, range);
    cut(gVolume.y * axis - foot.y, gVolume.y * axisRate - direction.y, range);
    cut(gVolume.y * axis + foot.y, gVolume.y * axisRate + direction.y, range);
    int planes = int(gDepths.z);
    [loop] for (int i = 0; i < planes; ++i)
        cut(dot(gPlanes[i].xyz, foot) + gPlanes[i].w, dot(gPlanes[i].xyz, direction.xyz), range);
    float extent = range.y - range.x;
    if (!(extent > 0.0))
        return float4(0.0, 0.0, 0.0, 0.0);

    // Rounding must not move an end before the near plane.
    float first = max(axis + range.x * axisRate, 0.999999 * gVolume.z);
    float last = max(axis + range.y * axisRate, 0.999999 * gVolume.z);
    bool away = axisRate > 0.0;  // from the lamp's plane: then lambda runs against the view ray
    float start = away ? range.y : range.x;
    Ray ray;
    ray.towards = away ? -1.0 : 1.0;
    ray.scale = extent / (first * last);
    ray.slope = clamp((foot.xy + start * direction.xy) / (away ? last : first), -gVolume.xy, gVolume.xy);
    ray.slopeRate = ray.towards * ray.scale * float2(-moment.y, moment.x);
    ray.inverse = 1.0 / (away ? last : first);
    ray.inverseRate = abs(axisRate) * ray.scale;
    float turn = difference_of_products(ray.slope.x, ray.slopeRate.y, ray.slope.y, ray.slopeRate.x);
    ray.arcRate = sqrt(dot(ray.slopeRate, ray.slopeRate) + turn * turn);
    ray.slant = sqrt(squared);
    ray.depth = start + footDepth + gPixel.z;
    ray.toEye = -direction.xyz / ray.slant;

    float3 sum = lit_air(ray, noise, shadow, cookie, scattering);
    if (!noise)
        sum *= gDust.x;

    float length = gWeight.x * (gWeight.y > 0.0 ? ray.slant : 1.0);
    float3 colour = gColour.rgb * sum * (ray.scale * length);
    float grey = dot(colour, float3(0.2126, 0.7152, 0.0722));  // Rec. 709 luminance
    return gChannels * float4(gColour.w > 0.0 ? float3(grey, grey, grey) : colour, grey);
}

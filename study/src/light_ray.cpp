#include "light_ray.h"

#include <cmath>
#include <limits>

namespace tyndall::study {
namespace {

// Keeps the part with a + b s >= 0.
Span clipped(Span span, double a, double b) {
    if (b > 0.0)
        span.begin = std::max(span.begin, -a / b);
    else if (b < 0.0)
        span.end = std::min(span.end, -a / b);
    else if (a < 0.0)
        span.end = span.begin;
    return span;
}

Span clipped(Span span, const LightRay& ray, glm::dvec3 normal, double offset) {
    return clipped(span, glm::dot(normal, ray.foot) + offset, glm::dot(normal, ray.direction));
}

}  // namespace

ViewRay viewRay(const View& view, int width, int height, double x, double y) {
    // Clip-space x and y are linear in a view-space point, and w depends on its depth alone. So for each depth two
    // linear equations give the point; depth 0 and the step for one metre describe the whole ray.
    const glm::dmat4& m = view.clipFromView;
    const glm::dvec2 ndc(2.0 * x / width - 1.0, 2.0 * y / height - 1.0);
    const glm::dmat2 across(m[0][0], m[0][1], m[1][0], m[1][1]);
    const auto solve = [&](double w, glm::dvec2 rest) { return glm::inverse(across) * (ndc * w - rest); };
    const glm::dvec2 start = solve(m[3][3], glm::dvec2(m[3]));
    const glm::dvec2 step = solve(-m[2][3], -glm::dvec2(m[2]));
    const glm::dvec3 perMetre(step, -1.0);
    const double length = glm::length(perMetre);
    return {glm::dvec3(start, 0.0), perMetre / length, length};
}

double depthOf(const View& view, const ViewRay& ray, double stored) {
    // z and w of the clip-space point at a depth are both linear in it.
    const glm::dmat4& m = view.clipFromView;
    const glm::dvec4 start = m * glm::dvec4(ray.origin, 1.0);
    const glm::dvec4 step = m * glm::dvec4(ray.direction * ray.perDepth, 0.0);
    const double depth = (stored * start.w - start.z) / (step.z - stored * step.w);
    return std::isfinite(depth) ? depth : std::numeric_limits<double>::infinity();
}

LightRay lightRay(const Light& light, const View& view, const ViewRay& ray) {
    // World positions may be large: subtract them before rotating.
    const glm::dmat3 lightFromWorld = glm::transpose(glm::dmat3(light.worldFromLight));
    const glm::dmat3 worldFromView(view.worldFromView);
    const glm::dvec3 eye = glm::dvec3(view.worldFromView[3]) - glm::dvec3(light.worldFromLight[3]);
    const glm::dvec3 origin = lightFromWorld * (eye + worldFromView * ray.origin);

    LightRay out;
    out.direction = glm::normalize(lightFromWorld * (worldFromView * ray.direction));
    out.footLength = -glm::dot(origin, out.direction);
    out.foot = origin + out.footLength * out.direction;
    out.foot -= glm::dot(out.foot, out.direction) * out.direction;
    out.distance = glm::length(out.foot);
    return out;
}

glm::dvec2 tanHalfFovOf(const Light& light) {
    return glm::tan(0.5 * light.fov);
}

Span clipToLight(const Light& light, const LightRay& ray, Span span) {
    const glm::dvec2 slope = tanHalfFovOf(light);
    span = clipped(span, ray, {0.0, 0.0, -1.0}, -light.nearPlane);
    span = clipped(span, ray, {0.0, 0.0, 1.0}, light.farPlane);
    for (const double side : {1.0, -1.0}) {
        span = clipped(span, ray, {side, 0.0, -slope.x}, 0.0);
        span = clipped(span, ray, {0.0, side, -slope.y}, 0.0);
    }
    const glm::dmat3 lightFromWorld = glm::transpose(glm::dmat3(light.worldFromLight));
    for (const glm::dvec4& plane : light.clipPlanes) {
        const glm::dvec3 normal(plane);
        span = clipped(span, ray, lightFromWorld * normal,
                       glm::dot(normal, glm::dvec3(light.worldFromLight[3])) + plane.w);
    }
    return span;
}

Projected project(const Light& light, const LightRay& ray) {
    const glm::dvec2 scale = 0.5 / tanHalfFovOf(light);
    const double c0 = -ray.foot.z, c1 = -ray.direction.z;
    return {{scale.x * ray.foot.x + 0.5 * c0, scale.x * ray.direction.x + 0.5 * c1, c0, c1},
            {-scale.y * ray.foot.y + 0.5 * c0, -scale.y * ray.direction.y + 0.5 * c1, c0, c1}};
}

ProjectedCoordinate scaled(const ProjectedCoordinate& coordinate, double factor, double offset) {
    return {factor * coordinate.n0 + offset * coordinate.c0, factor * coordinate.n1 + offset * coordinate.c1,
            coordinate.c0, coordinate.c1};
}

}  // namespace tyndall::study

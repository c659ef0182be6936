// A view ray in the space of a light, measured from its point nearest to the lamp.
#pragma once

#include <tyndall/light.h>
#include <tyndall/view.h>

#include <cmath>
#include <glm/glm.hpp>

namespace tyndall::study {

/// A stretch of a ray, metres along it; empty unless begin < end.
struct Span {
    double begin = 0.0, end = 0.0;
    bool empty() const { return !(begin < end); }
    double middle() const { return 0.5 * (begin + end); }
};

/// A view ray: the line of sight through one point of the picture.
struct ViewRay {
    glm::dvec3 origin;     ///< view space, at depth 0
    glm::dvec3 direction;  ///< unit length
    double perDepth;       ///< metres of ray for one metre of view depth
};

/// Through the point `x`, `y` of a picture of `width` x `height` pixels, (0, 0) its top left corner.
ViewRay viewRay(const View& view, int width, int height, double x, double y);

/// View depth at which a depth buffer stores `stored`; infinite if there is none.
double depthOf(const View& view, const ViewRay& ray, double stored);

/// Point(s) = foot + s * direction in light space, where `foot` is nearest to the lamp at the origin. Measuring s from
/// there, with `foot` exactly perpendicular to the ray, keeps rays that graze the lamp accurate.
struct LightRay {
    glm::dvec3 foot, direction;
    double distance;    ///< of the foot from the lamp, metres
    double footLength;  ///< metres along the view ray to the foot

    glm::dvec3 at(double s) const { return foot + s * direction; }
    double axis(double s) const { return -foot.z - s * direction.z; }  ///< metres along the light's axis
    /// Cosine between the light's axis and the direction from the lamp.
    double cosine(double s) const { return axis(s) / std::hypot(distance, s); }
};

LightRay lightRay(const Light& light, const View& view, const ViewRay& ray);

/// The part of `span` inside the light's pyramid and its extra clip planes.
Span clipToLight(const Light& light, const LightRay& ray, Span span);

/// A coordinate of the light's projection along a ray, (n0 + n1 s) / (c0 + c1 s): monotonic where the denominator, the
/// distance along the axis, is positive.
struct ProjectedCoordinate {
    double n0, n1, c0, c1;

    double at(double s) const { return (n0 + n1 * s) / (c0 + c1 * s); }
    /// The s at which it has the value k.
    double crossing(double k) const { return (n0 - k * c0) / (k * c1 - n1); }
};

/// Tangents of half the field of view. The reference has its own, and shares no code with the plan.
glm::dvec2 tanHalfFovOf(const Light& light);

/// Texture coordinates of a texture that the light projects: u from 0 at light-space -X to 1, v from 0 at +Y.
struct Projected {
    ProjectedCoordinate u, v;
};
Projected project(const Light& light, const LightRay& ray);

/// factor * coordinate + offset.
ProjectedCoordinate scaled(const ProjectedCoordinate& coordinate, double factor, double offset);

}  // namespace tyndall::study

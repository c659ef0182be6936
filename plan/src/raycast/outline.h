// The polygon of the picture in which a light's seen volume lies.
#pragma once

#include <tyndall/view.h>

#include <glm/glm.hpp>
#include <vector>

#include "geometry/convex_polyhedron.h"

namespace tyndall {

/// Appends the convex hull of the solid's corners in clip coordinates, counter-clockwise with y up, widened by `margin`
/// and cut to the picture. The solid lies before the eye.
void appendOutline(std::vector<glm::dvec2>& outline, const ConvexPolyhedron& solid, const View& view, double margin);

/// Appends the four corners of the picture.
void appendPicture(std::vector<glm::dvec2>& outline);

}  // namespace tyndall

// Ray casting with Embree: the ends of view rays, and visibility between a lamp and a point.
#pragma once

#include <study/reference.h>

#include <memory>
#include <vector>

#include "light_ray.h"

namespace tyndall::study {

/// Triangles for ray casting. They are stored relative to the eye, where Embree's floats resolve best.
class Surfaces {
public:
    Surfaces(const View& view, const std::vector<Triangle>& triangles);
    Surfaces(Surfaces&&) noexcept;
    Surfaces& operator=(Surfaces&&) noexcept;
    ~Surfaces();

    /// Metres along the ray from depth 0 to the first surface that can be seen from there, between `begin` and
    /// `end` metres; infinite if there is none. Embree finds the triangle; its distance is computed in doubles.
    double firstHit(const ViewRay& ray, double begin, double end) const;

    /// Whether any triangle, from either side, lies between two points of view space.
    bool blocked(const glm::dvec3& from, const glm::dvec3& to) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tyndall::study

// Where view rays end and what stands between a lamp and a point: ray casting with Embree.
#pragma once

#include <study/reference.h>

#include <memory>
#include <vector>

#include "light_ray.h"

namespace tyndall::study {

/// Triangles for ray casting. They are kept relative to the eye: Embree's floats resolve what is near it best.
class Surfaces {
public:
    Surfaces(const View& view, const std::vector<Triangle>& triangles);
    Surfaces(Surfaces&&) noexcept;
    Surfaces& operator=(Surfaces&&) noexcept;
    ~Surfaces();

    /// Metres along the ray from depth 0 to the first surface that can be seen from there, between `begin` and
    /// `end` metres; infinite where there is none. Embree names the triangle, doubles give the distance.
    double firstHit(const ViewRay& ray, double begin, double end) const;

    /// Whether any triangle, from whichever side, stands between two points of view space.
    bool blocked(const glm::dvec3& from, const glm::dvec3& to) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tyndall::study

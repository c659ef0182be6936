// The six half spaces that bound a part of a light's volume, each by its name.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace tyndall {

struct FrustumPlanes {
    glm::dvec4 left{0.0}, right{0.0}, bottom{0.0}, top{0.0}, near{0.0}, far{0.0};

    std::array<glm::dvec4, 4> sides() const { return {left, right, bottom, top}; }
    std::array<glm::dvec4, 6> all() const { return {left, right, bottom, top, near, far}; }
};

/// Applies `change` to each plane.
template <class Change>
FrustumPlanes changed(const FrustumPlanes& planes, Change&& change) {
    return {change(planes.left), change(planes.right), change(planes.bottom),
            change(planes.top),  change(planes.near),  change(planes.far)};
}

/// Which side of a bound a half space keeps.
enum class Keep { Above = 1, Below = -1 };

/// Light-space half space of the points that lie more, or less, than `axis` metres along the light's axis. Unit normal.
inline glm::dvec4 axisPlane(double axis, Keep keep) {
    const auto sign = static_cast<double>(keep);
    return {0.0, 0.0, -sign, -sign * axis};
}

}  // namespace tyndall

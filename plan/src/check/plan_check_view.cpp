#include <cfloat>
#include <cmath>

#include "check/plan_check.h"

namespace tyndall {
namespace {

const std::string place = "view";

// 1 / tan(179 degrees / 2): wider pictures stretch over a hundred times their distance, and resolve nothing.
constexpr double minScale = 0.00872686779;

// The eye stands at the origin and looks along -Z: clip w is the depth (perspective) or constant.
Result<void> checkProjection(const View& view) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(view.clipFromView[column][row]))
                return broken(place + ": clipFromView has " + text(view.clipFromView[column][row]) + " in row " +
                              std::to_string(row) + ", column " + std::to_string(column) +
                              ": it must be finite; give a field of view over 0 and under 180 degrees, or half extents "
                              "over 0");
    const glm::dmat4 rows = glm::transpose(view.clipFromView);
    const glm::dvec4 w = rows[3];
    const double weight = view.orthographic ? w.w : -w.z;
    const glm::dvec4 expected = view.orthographic ? glm::dvec4(0, 0, 0, weight) : glm::dvec4(0, 0, -weight, 0);
    if (!(weight > 0.0) || glm::length(w - expected) > 1e-6 * weight)
        return broken(place + ": clipFromView has the last row (" + text(w.x) + ", " + text(w.y) + ", " + text(w.z) +
                      ", " + text(w.w) + ") with orthographic " + (view.orthographic ? "true" : "false") +
                      ": it must be " + (view.orthographic ? "(0, 0, 0, k)" : "(0, 0, -k, 0)") +
                      " with k over 0; set orthographic to what the projection is, with the eye at the origin looking "
                      "along -Z");
    for (int axis = 0; axis < 2; ++axis) {
        const double scale = glm::length(glm::dvec2(rows[axis])) / weight;
        if (view.orthographic ? !(scale >= 1.0 / farthest) : !(scale >= minScale))
            return broken(place + ": clipFromView scales " + (axis == 0 ? "x" : "y") + " by " + text(scale) +
                          ": it must be " +
                          (view.orthographic ? "1e-9 or more; give half extents up to 1e9 m"
                                             : "0.00872687 or more; give a field of view up to 179 degrees"));
    }
    if (!(std::fabs(glm::determinant(view.clipFromView)) > 0.0))
        return broken(place +
                      ": clipFromView is singular: depth must depend on distance, and x and y on different "
                      "directions; make it with perspectiveView() or orthographicView()");
    return {};
}

}  // namespace

Result<void> checkView(const View& view) {
    if (const Result<void> checked = checkRigid({place}, "worldFromView", view.worldFromView); !checked) return checked;
    const Bound bounds[] = {
        {"nearPlane", view.nearPlane, DBL_MIN, farthest, "over 0 and at most 1e9 m", "0.1 is a good start"},
        {"farPlane", view.farPlane, -DBL_MAX, HUGE_VAL, "a number", "give metres, or infinity"},
        {"sceneDepth", view.sceneDepth, DBL_MIN, DBL_MAX, "over 0 and finite", "leave it at its default where unknown"},
    };
    if (const Result<void> checked = checkBounds({place}, bounds); !checked) return checked;
    if (!(view.farPlane > view.nearPlane))
        return broken(place + ": farPlane is " + text(view.farPlane) + ": it must be beyond nearPlane, " +
                      text(view.nearPlane) + "; raise farPlane or lower nearPlane");
    if (view.orthographic && std::isinf(view.farPlane))
        return broken(place +
                      ": farPlane is infinite: it must be finite in an orthographic view, whose depth is "
                      "linear; give the depth of the farthest thing to be seen");
    return checkProjection(view);
}

}  // namespace tyndall

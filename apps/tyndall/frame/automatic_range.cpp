#include "automatic_range.h"

#include <tyndall/air.h>
#include <tyndall/article.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tyndall::app {
namespace {

constexpr int columns = 32, rows = 18, steps = 256;
// A cell that may be this many times brighter than every ray so far is divided in four, up to this many times.
constexpr double tooWide = 1.2;
constexpr int maxCuts = 3;
constexpr double smallest = 1e-9;

/// Metres from the eye to the farthest lit air in the view.
double farthestLit(std::span<const Light> lights, const View& view) {
    double farthest = view.nearPlane * 2.0;
    for (const Light& light : lights) {
        const double lamp = glm::length(glm::dvec3(light.worldFromLight[3] - view.worldFromView[3]));
        farthest = std::max(farthest, lamp + maxDistance(light));
    }
    return std::min({farthest, view.farPlane, std::max(view.sceneDepth, view.nearPlane * 2.0)});
}

double scattered(const Light& light, const glm::dmat4& lightFromWorld, const glm::dvec3& world, Look look) {
    const glm::dvec3 p(lightFromWorld * glm::dvec4(world, 1.0));
    const double axis = -p.z;
    if (axis < light.nearPlane || axis > light.farPlane) return 0.0;
    const glm::dvec2 half = axis * tanHalfFov(light);
    if (std::abs(p.x) > half.x || std::abs(p.y) > half.y) return 0.0;
    for (const glm::dvec4& plane : light.clipPlanes)
        if (glm::dot(plane, glm::dvec4(world, 1.0)) < 0.0) return 0.0;
    const double brightest = std::max({light.colour.r, light.colour.g, light.colour.b});
    if (look == Look::Article) {
        const glm::dvec3 inches = article::inchesPerMetre * p;
        return brightest * (article::ambient + article::intensity / glm::dot(inches, inches));
    }
    return brightest * light.density / (4.0 * std::numbers::pi) * (light.intensity / glm::dot(p, p) + light.ambient);
}

/// A cell of the picture, in clip space.
struct Cell {
    double x, y, halfWidth, halfHeight;
};

/// A step of the view ray through the middle of a cell of the grid.
struct Step {
    glm::dvec3 middle, toEye;  ///< world space; toEye has unit length
    double fromEye;            ///< metres along the ray from the eye, or the plane of depth 0
    double angle, width;       ///< from the ray to the cell's corners, in radians and in metres at the step
};

struct Range {
    double middle = 0.0, bound = 0.0;  ///< on the ray through a cell's middle; on all of the cell's rays
};

/// phase * transmittance; the bound uses the largest phase function and the shortest path.
Range shareOfAir(const Light& light, const Step& step) {
    const glm::dvec3 lamp(light.worldFromLight[3]), fromLamp = step.middle - lamp;
    const double distance = glm::length(fromLamp);
    Range share{1.0, 1.0};
    if (light.anisotropy != 0.0) {
        const double turn = std::acos(std::clamp(glm::dot(fromLamp, step.toEye) / distance, -1.0, 1.0));
        const double other = step.angle + std::asin(std::min(step.width / distance, 1.0));
        share.middle = phase(light.anisotropy, turn);
        share.bound = phase(light.anisotropy, light.anisotropy < 0.0 ? std::min(turn + other, std::numbers::pi)
                                                                     : std::max(turn - other, 0.0));
    }
    if (const double loss = extinction(light); loss > 0.0) {
        const double way = distance + step.fromEye;
        share.middle *= std::exp(-loss * way);
        share.bound *= std::exp(-loss * std::max(way - step.width, 0.0));
    }
    return share;
}

/// For the parts that the light is drawn with.
bool scatters(const Light& light, const PlanOptions& options) {
    return options.look == Look::Physical && (light.anisotropy != 0.0 || light.albedo) &&
           (!options.terms || options.terms->contains(Term::Scattering));
}

}  // namespace

double automaticRange(std::span<const Light> lights, const View& view, const PlanOptions& options) {
    std::vector<glm::dmat4> lightFromWorld;
    for (const Light& light : lights) lightFromWorld.push_back(glm::inverse(light.worldFromLight));
    const double farthest = farthestLit(lights, view);
    const glm::dmat4 viewFromClip = glm::inverse(view.clipFromView);
    // The article adds a constant for each of its slices, independent of the thickness.
    const double perStep = options.look == Look::Article ? article::weight * article::flatDust / steps
                                                         : (farthest - view.nearPlane) / steps;
    const auto rayAt = [&](double x, double y) {  // start on the near plane and direction for a metre of depth
        const glm::dvec4 onNear = viewFromClip * glm::dvec4(x, y, 1.0, 1.0);  // reversed depth: 1 is near
        const glm::dvec3 start(onNear / onNear.w);
        return std::pair(start, view.orthographic ? glm::dvec3(0.0, 0.0, -1.0) : start / -start.z);
    };
    const auto radiance = [&](const Cell& cell) {
        const auto [start, direction] = rayAt(cell.x, cell.y);
        const glm::dvec3 origin = view.orthographic ? glm::dvec3(start.x, start.y, 0.0) : glm::dvec3(0.0);
        const double slant = glm::length(direction);
        // Equal cells have larger angles near the picture's middle: the corner towards it is the farthest.
        const auto [corner, outermost] =
            rayAt(cell.x - std::copysign(cell.halfWidth, cell.x), cell.y - std::copysign(cell.halfHeight, cell.y));
        const double angle = std::atan2(glm::length(glm::cross(direction, outermost)), glm::dot(direction, outermost));
        const double width = view.orthographic ? glm::distance(start, corner) : 0.0;
        const glm::dvec3 toEye(view.worldFromView * glm::dvec4(-direction / slant, 0.0));
        Range sum;
        for (int step = 0; step < steps; ++step) {
            const double depth = view.nearPlane + (farthest - view.nearPlane) * (step + 0.5) / steps;
            const glm::dvec3 world(view.worldFromView * glm::dvec4(origin + depth * direction, 1.0));
            const Step here{world, toEye, slant * depth, angle, width + slant * depth * angle};
            for (std::size_t i = 0; i < lights.size(); ++i) {
                const double even = scattered(lights[i], lightFromWorld[i], world, options.look);
                const bool plain = !(even > 0.0) || !scatters(lights[i], options);
                const Range share = plain ? Range{1.0, 1.0} : shareOfAir(lights[i], here);
                sum.middle += even * share.middle;
                sum.bound += even * share.bound;
            }
        }
        const double metres = perStep * (options.look == Look::Article ? 1.0 : slant);
        return Range{sum.middle * metres, sum.bound * metres};
    };

    std::vector<std::pair<Cell, Range>> cells, parts;
    double known = smallest;
    const auto add = [&](std::vector<std::pair<Cell, Range>>& to, const Cell& cell) {
        to.emplace_back(cell, radiance(cell));
        known = std::max(known, to.back().second.middle);
    };
    for (int pixel = 0; pixel < columns * rows; ++pixel)
        add(cells, {2.0 * (pixel % columns + 0.5) / columns - 1.0, 2.0 * (pixel / columns + 0.5) / rows - 1.0,
                    1.0 / columns, 1.0 / rows});
    double brightest = smallest;
    for (int cuts = 0; !cells.empty(); ++cuts) {
        parts.clear();
        for (const auto& [cell, range] : cells) {
            if (cuts == maxCuts || !(range.bound > tooWide * known)) {
                brightest = std::max(brightest, range.bound);
                continue;
            }
            const double w = 0.5 * cell.halfWidth, h = 0.5 * cell.halfHeight;
            for (const glm::dvec2 side : {glm::dvec2(-w, -h), {w, -h}, {-w, h}, {w, h}})
                add(parts, {cell.x + side.x, cell.y + side.y, w, h});
        }
        cells.swap(parts);
    }
    return brightest;
}

}  // namespace tyndall::app

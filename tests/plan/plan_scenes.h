// Lights, eyes and measurements that the plan's tests share, independent of the planner's code.
#pragma once

#include <gtest/gtest.h>
#include <tyndall/explain.h>
#include <tyndall/plan.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace tyndall::test {

inline constexpr double degrees = 3.14159265358979323846 / 180.0;

/// A slide projector of 40 by 24 degrees, from 0.5 m to 6 m.
inline Light projector() {
    Light light;
    light.fov = {40.0 * degrees, 24.0 * degrees};
    light.nearPlane = 0.5;
    light.farPlane = 6.0;
    light.intensity = 100.0;
    light.shadow = false;
    return light;
}

/// The light with exactly these terms.
inline Light withTerms(Light light, TermSet terms) {
    if (!light.noise) light.noise.emplace();
    light.shadow = light.cookie = true;
    light.anisotropy = 0.3;
    return keepOnly(light, terms);
}

inline double pyramidVolume(const Light& light) {
    const double section = 4.0 * std::tan(0.5 * light.fov.x) * std::tan(0.5 * light.fov.y);
    return section / 3.0 * (std::pow(light.farPlane, 3.0) - std::pow(light.nearPlane, 3.0));
}

inline glm::dmat4 pose(const glm::dquat& rotation, const glm::dvec3& position) {
    glm::dmat4 matrix = glm::mat4_cast(glm::normalize(rotation));
    matrix[3] = glm::dvec4(position, 1.0);
    return matrix;
}

/// Stands at `position` and looks at `target`.
inline glm::dmat4 lookingAt(const glm::dvec3& position, const glm::dvec3& target,
                            const glm::dvec3& up = {0.0, 1.0, 0.0}) {
    const glm::dvec3 back = glm::normalize(position - target);
    const glm::dvec3 right = glm::normalize(glm::cross(up, back));
    return {glm::dvec4(right, 0.0), glm::dvec4(glm::cross(back, right), 0.0), glm::dvec4(back, 0.0),
            glm::dvec4(position, 1.0)};
}

using Random = std::mt19937_64;

inline double between(Random& random, double min, double max) {
    return std::uniform_real_distribution<double>(min, max)(random);
}

inline glm::dvec3 inCube(Random& random, double half) {
    return {between(random, -half, half), between(random, -half, half), between(random, -half, half)};
}

/// Uniform over all rotations, up to `distance` from the origin along each axis.
inline glm::dmat4 rigidMotion(Random& random, double distance) {
    std::normal_distribution<double> normal;
    const glm::dquat rotation(normal(random), normal(random), normal(random), normal(random));
    return pose(rotation, inCube(random, distance));
}

/// A plane of the world after the world has been moved rigidly.
inline glm::dvec4 moved(const glm::dmat4& motion, const glm::dvec4& plane) {
    const glm::dvec3 normal = glm::dmat3(motion) * glm::dvec3(plane);
    return {normal, plane.w - glm::dot(normal, glm::dvec3(motion[3]))};
}

/// A view wide enough to hold everything before it in its guard band: 120 degrees, from 1 cm to infinity.
inline View wideView(const glm::dmat4& worldFromView) {
    return perspectiveView(worldFromView, 120.0 * degrees, 1.0, 0.01, std::numeric_limits<double>::infinity());
}

/// The same point in another space, by general inversion.
inline glm::dvec3 lightFromView(const Light& light, const View& view, const glm::dvec3& point) {
    return glm::dvec3(glm::inverse(light.worldFromLight) * (view.worldFromView * glm::dvec4(point, 1.0)));
}

/// Signed distances, positive inside, to the six sides of the light's pyramid and its clip planes. All are
/// linear in the point.
inline std::vector<double> distances(const Light& light, const View& view, const glm::dvec3& viewPoint) {
    const glm::dvec3 p = lightFromView(light, view, viewPoint);
    const glm::dvec3 world(view.worldFromView * glm::dvec4(viewPoint, 1.0));
    const double w = -p.z;
    const glm::dvec2 half = 0.5 * light.fov;
    std::vector<double> all = {w - light.nearPlane, light.farPlane - w};
    for (const double side : {1.0, -1.0}) {
        all.push_back(w * std::sin(half.x) + side * p.x * std::cos(half.x));
        all.push_back(w * std::sin(half.y) + side * p.y * std::cos(half.y));
    }
    for (const glm::dvec4& plane : light.clipPlanes)
        all.push_back(glm::dot(plane, glm::dvec4(world, 1.0)) / glm::length(glm::dvec3(plane)));
    return all;
}

inline double insideBy(const Light& light, const View& view, const glm::dvec3& viewPoint) {
    const std::vector<double> all = distances(light, view, viewPoint);
    return *std::min_element(all.begin(), all.end());
}

/// Metres of view depth over which a ray from `zero` (at depth 0) through `one` (at depth 1) is inside.
inline double depthInside(const Light& light, const View& view, const glm::dvec3& zero, const glm::dvec3& one) {
    const std::vector<double> start = distances(light, view, zero);
    const std::vector<double> next = distances(light, view, one);
    double from = view.nearPlane, to = std::min(view.farPlane, view.sceneDepth);
    for (std::size_t i = 0; i < start.size(); ++i) {
        const double slope = next[i] - start[i];
        if (slope > 0.0) from = std::max(from, -start[i] / slope);
        if (slope < 0.0) to = std::min(to, -start[i] / slope);
        if (slope == 0.0 && start[i] < 0.0) return 0.0;
    }
    return std::max(0.0, to - from);
}

using Corners = std::vector<glm::dvec2>;

/// The slices of one light with exact polygons, by depth, nearest first: the corners in their order.
inline std::map<float, Corners> slicesOf(const Plan& plan, const PlannedLight& light) {
    std::map<float, Corners> slices;
    std::vector<bool> seen(plan.vertices.size(), false);
    for (std::uint32_t i = light.firstIndex; i < light.firstIndex + light.indexCount; ++i) {
        const std::uint32_t number = plan.indices.at(i);
        if (seen.at(number)) continue;
        seen[number] = true;
        const glm::vec3 position = plan.vertices[number].position;
        slices[-position.z].push_back(glm::dvec2(position));
    }
    return slices;
}

inline double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Sum over one light's triangles of area times thickness: cubic metres. Clockwise triangles count negative.
inline double summedVolume(const Plan& plan, const PlannedLight& light) {
    double sum = 0.0;
    for (std::uint32_t i = light.firstIndex; i < light.firstIndex + light.indexCount; i += 3) {
        const SliceVertex& a = plan.vertices.at(plan.indices.at(i));
        const SliceVertex& b = plan.vertices.at(plan.indices.at(i + 1));
        const SliceVertex& c = plan.vertices.at(plan.indices.at(i + 2));
        const double twice =
            cross(glm::dvec2(b.position) - glm::dvec2(a.position), glm::dvec2(c.position) - glm::dvec2(a.position));
        sum += 0.5 * twice * a.thickness;
    }
    return sum;
}

/// Minimum signed distance of a point to the sides of a counter-clockwise convex polygon, positive inside.
inline double insideBy(const Corners& polygon, const glm::dvec2& point) {
    double min = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 start = polygon[i];
        const glm::dvec2 side = polygon[(i + 1) % polygon.size()] - start;
        if (glm::length(side) > 0.0) min = std::min(min, cross(side, point - start) / glm::length(side));
    }
    return min;
}

inline Plan planned(const std::vector<Light>& lights, const View& view, const PlanOptions& options) {
    Result<Plan> result = plan(lights, view, options);
    EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().message);
    return result ? *std::move(result) : Plan{};
}

/// The uniform block of a drawn light.
inline const SliceConstants& constantsOf(const Plan& plan, std::size_t light) {
    const auto part =
        std::find_if(plan.parts.begin(), plan.parts.end(), [&](const PlannedPart& p) { return p.light == light; });
    if (part == plan.parts.end()) throw std::out_of_range("the light has no part");
    return plan.constants.at(part->constants);
}

/// The lights of a group, each once, in ascending order.
inline std::vector<std::size_t> lightsOf(const Plan& plan, std::size_t group) {
    const CompositeGroup& found = plan.groups.at(group);
    std::set<std::size_t> lights;
    for (std::uint32_t i = 0; i < found.parts; ++i) lights.insert(plan.parts.at(found.firstPart + i).light);
    return {lights.begin(), lights.end()};
}

inline PlanOptions slices(int number) {
    PlanOptions options;
    options.slices = number;
    return options;
}

struct Scene {
    Light light;
    View view;
};

/// A projector nearby in a random pose, all of it before the eye.
inline Scene randomScene(Random& random) {
    Scene scene{projector(), wideView(rigidMotion(random, 20.0))};
    glm::dmat4 viewFromLight = rigidMotion(random, 2.0);
    viewFromLight[3].z -= 10.0;
    scene.light.worldFromLight = scene.view.worldFromView * viewFromLight;
    return scene;
}

}  // namespace tyndall::test

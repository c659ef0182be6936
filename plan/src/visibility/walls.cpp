#include "visibility/walls.h"

#include <algorithm>
#include <cmath>

#include "shape/light_shape.h"
#include "shape/shadow_projection.h"

namespace tyndall {
namespace {

struct Candidate {
    std::size_t blocker = 0;
    glm::dvec4 plane{0.0};  ///< light space, the lamp on its positive side
};
using Candidates = InlineVector<Candidate, maxWalls>;

// The maximum signed distance from the plane to the volume's cross-section `axis` metres along its axis.
double maxSignedDistance(const glm::dvec4& plane, const LightShape& shape, double axis, double sign) {
    double max = -1e300;
    for (const glm::dvec3& corner : cornersAt(shape, axis))
        max = std::max(max, sign * glm::dot(plane, glm::dvec4(corner, 1.0)));
    return max;
}

// Light-space half spaces of the volume's sides and far end, with unit normals.
InlineVector<glm::dvec4, 5> unitPlanesBeyondNear(const LightShape& shape) {
    const FrustumPlanes shapePlanes = planesOf(shape);
    InlineVector<glm::dvec4, 5> planes;
    for (const glm::dvec4& side : shapePlanes.sides()) planes.push_back(unitPlane(side));
    planes.push_back(shapePlanes.far);
    return planes;
}

// A wall needs a bias that keeps its shadow off the air before it. That bias delays every shadow of the light by the
// same length. A wall that needs more than this share of its distance is too steep: it is treated as an ordinary
// occluder.
constexpr double maxMapError = 1.0 / 200.0;

bool steep(const glm::dvec4& plane, const LightShape& shape, std::uint32_t mapSize) {
    return mapErrorShare(shape, plane, mapSize, maxAxisOn(plane, shape)) > maxMapError;
}

// World-space corners of the picture on the view's near plane, where its rays begin.
std::array<glm::dvec3, 4> nearCorners(const View& view) {
    const glm::dmat4 rows = glm::transpose(view.clipFromView);
    const glm::dvec4 axis(0.0, 0.0, -view.nearPlane, 1.0);
    const double w = glm::dot(rows[3], axis);
    const glm::dmat2 plane = glm::inverse(glm::dmat2(rows[0].x, rows[1].x, rows[0].y, rows[1].y));
    std::array<glm::dvec3, 4> corners;
    for (int i = 0; i < 4; ++i) {
        const glm::dvec2 clip((i & 1) ? w : -w, (i & 2) ? w : -w);
        const glm::dvec2 across = plane * (clip - glm::dvec2(glm::dot(rows[0], axis), glm::dot(rows[1], axis)));
        corners[i] = glm::dvec3(view.worldFromView * glm::dvec4(across, -view.nearPlane, 1.0));
    }
    return corners;
}

// The largest blockers whose planes cross the volume beyond its near end.
Candidates candidatesFor(const Light& light, const LightShape& shape, const View& view,
                         std::span<const BlockerBounds> bounds, std::uint32_t mapSize) {
    const glm::dvec3 lamp(light.worldFromLight[3]);
    const std::array<glm::dvec3, 4> picture = nearCorners(view);
    const glm::dmat3 lightFromWorld = glm::inverse(glm::dmat3(light.worldFromLight));
    const InlineVector<glm::dvec4, 5> sides = unitPlanesBeyondNear(shape);
    Candidates found;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const BlockerBounds& blocker = bounds[i];
        if (!(blocker.area > 0.0)) continue;
        const glm::dvec3 centre = lightFromWorld * (blocker.centre - lamp);
        if (std::any_of(sides.begin(), sides.end(), [&](const glm::dvec4& side) {
                return glm::dot(side, glm::dvec4(centre, 1.0)) < -blocker.radius;
            }))
            continue;
        const glm::dvec3 normal(blocker.plane);
        // Relative to a point of the blocker: far from the origin, the plane's offset loses precision.
        double lampDistance = glm::dot(normal, lamp - blocker.centre);
        if (std::any_of(picture.begin(), picture.end(), [&](const glm::dvec3& corner) {
                return !(lampDistance * glm::dot(normal, corner - blocker.centre) > 0.0);
            }))
            continue;
        const double sign = lampDistance > 0.0 ? 1.0 : -1.0;
        lampDistance *= sign;
        const glm::dvec4 plane(sign * (lightFromWorld * normal), lampDistance);
        if (maxSignedDistance(plane, shape, light.nearPlane, -1.0) >= 0.0) continue;  // would cut the near end
        if (maxSignedDistance(plane, shape, light.farPlane, -1.0) <= 0.0) continue;   // beyond the far end
        if (steep(plane, shape, mapSize)) continue;
        Candidate candidate{i, plane};
        if (found.size() < maxWalls) {
            found.push_back(candidate);
        } else {
            Candidate* smallest = std::min_element(found.begin(), found.end(), [&](const auto& a, const auto& b) {
                return bounds[a.blocker].area < bounds[b.blocker].area;
            });
            if (bounds[smallest->blocker].area < blocker.area) *smallest = candidate;
        }
    }
    return found;
}

// Coordinates in which the plane is z = 0: slicePolygon() with depth 0 then cuts within the plane.
struct Frame {
    glm::dmat3 planeFromLight;
    glm::dvec3 origin;  ///< of light space
};

Frame frameOf(const glm::dvec4& plane) {
    const glm::dvec3 n(plane);
    const glm::dvec3 other = std::fabs(n.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 u = glm::normalize(glm::cross(other, n));
    return {glm::transpose(glm::dmat3(u, glm::cross(n, u), n)), -plane.w * n};
}

glm::dvec4 inFrame(const Frame& frame, const glm::dvec4& plane) {
    return {frame.planeFromLight * glm::dvec3(plane), glm::dot(glm::dvec3(plane), frame.origin) + plane.w};
}

// A half plane adds one corner to a convex polygon; the second is for rounding.
constexpr std::size_t maxCornersToSplit = SlicePolygon::capacity - 2;

// Adds to `left` the convex pieces of `whole` outside of the triangle. False: a piece has too many corners to be split.
bool subtract(const SlicePolygon& whole, std::array<glm::dvec2, 3> triangle, std::vector<SlicePolygon>& left) {
    const auto turn = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
    if (turn(triangle[1] - triangle[0], triangle[2] - triangle[0]) < 0.0) std::swap(triangle[1], triangle[2]);
    SlicePolygon rest = whole;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 side = triangle[(i + 1) % 3] - triangle[i];
        const double length = glm::length(side);
        if (length == 0.0) {  // no triangle
            left.push_back(whole);
            return true;
        }
        if (rest.count > maxCornersToSplit) return false;
        const glm::dvec2 inward = glm::dvec2(-side.y, side.x) / length;
        const double offset = -glm::dot(inward, triangle[i]);
        SlicePolygon inside, outside;
        split(rest, inward, offset, inside, outside);
        if (outside.count >= 3) left.push_back(outside);
        if (inside.count < 3) return true;
        rest = inside;
    }
    return true;
}

// With more pieces than this, the test costs more than drawing the air behind.
constexpr std::size_t maxPieces = 256;
// Share of the face's diameter: rounding leaves cracks of at most this width between triangles in 32-bit floats.
constexpr double crack = 1e-6;

// A piece's area over its length.
double width(const SlicePolygon& piece) {
    glm::dvec2 min(piece.corners[0]), max = min;
    for (std::size_t i = 1; i < piece.count; ++i) {
        min = glm::min(min, piece.corners[i]);
        max = glm::max(max, piece.corners[i]);
    }
    return area(piece) / glm::length(max - min);
}

// Whether the blocker's triangles cover the wall's face. `touched`: there is such a face.
bool covered(const Candidate& wall, const Candidates& walls, const Light& light, const LightShape& shape,
             const Blocker& blocker, WallScratch& scratch, bool& touched) {
    const Frame frame = frameOf(wall.plane);
    InlineVector<glm::dvec4, 5 + maxWalls> planes;
    for (const glm::dvec4& plane : unitPlanesBeyondNear(shape)) planes.push_back(inFrame(frame, plane));
    for (const Candidate& other : walls)
        if (other.blocker != wall.blocker) planes.push_back(inFrame(frame, other.plane));
    const double half = 4.0 * maxDistance(shape);
    const SlicePolygon face = slicePolygon(glm::dvec2(-half), glm::dvec2(half), planes, 0.0);
    touched = face.count >= 3;
    if (!touched) return true;

    double diameter = 0.0;
    for (std::size_t i = 0; i < face.count; ++i)
        diameter = std::max(diameter, 2.0 * glm::length(face.corners[i] - face.corners[0]));
    scratch.uncovered.clear();
    scratch.uncovered.push_back(face);
    const glm::dvec3 lamp(light.worldFromLight[3]);
    const glm::dmat3 planeFromWorld = frame.planeFromLight * glm::inverse(glm::dmat3(light.worldFromLight));
    const glm::dvec3 origin = frame.planeFromLight * frame.origin;
    for (const std::array<glm::dvec3, 3>& corners : blocker.triangles) {
        std::array<glm::dvec2, 3> triangle;
        for (std::size_t i = 0; i < 3; ++i) triangle[i] = glm::dvec2(planeFromWorld * (corners[i] - lamp) - origin);
        scratch.left.clear();
        for (const SlicePolygon& piece : scratch.uncovered)
            if (!subtract(piece, triangle, scratch.left)) return false;
        std::swap(scratch.left, scratch.uncovered);
        double widest = 0.0;
        for (const SlicePolygon& piece : scratch.uncovered) widest = std::max(widest, width(piece));
        if (widest <= crack * diameter) return true;
        if (scratch.uncovered.size() > maxPieces) return false;
    }
    return false;
}

}  // namespace

InlineVector<glm::dvec4, maxWalls> wallsOf(const Light& light, const View& view, const LightPose& pose,
                                           const BlockerSet& blockers, std::uint32_t mapSize, WallScratch& scratch) {
    const LightShape shape = shapeOf(light);
    Candidates walls = candidatesFor(light, shape, view, blockers.bounds(), mapSize);
    // An uncovered candidate is not a wall. Its removal enlarges the faces of the others, so they are tested again.
    std::array<bool, maxWalls> touched{};
    for (bool changed = true; changed && !walls.empty();) {
        changed = false;
        for (std::size_t i = 0; i < walls.size() && !changed; ++i) {
            if (covered(walls[i], walls, light, shape, blockers.blockers()[walls[i].blocker], scratch, touched[i]))
                continue;
            Candidates kept;
            for (std::size_t k = 0; k < walls.size(); ++k)
                if (k != i) kept.push_back(walls[k]);
            walls = kept;
            changed = true;
        }
    }
    InlineVector<glm::dvec4, maxWalls> planes;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (!touched[i]) continue;  // the other walls stop the light before it
        const Candidate& wall = walls[i];
        const glm::dvec4 behind = wall.plane + glm::dvec4(0.0, 0.0, 0.0, wallMargin(wall.plane.w));
        planes.push_back(unitPlane(behind * pose.lightFromView));
    }
    return planes;
}

double mapErrorAt(std::span<const glm::dvec4> walls, const Light& light, const LightPose& pose, double axisLit,
                  std::uint32_t mapSize) {
    const LightShape shape = shapeOf(light);
    double max = 0.0;
    for (const glm::dvec4& wall : walls)
        max = std::max(max, mapErrorShare(shape, unitPlane(wall * pose.viewFromLight), mapSize, axisLit));
    return max * axisLit;
}

}  // namespace tyndall

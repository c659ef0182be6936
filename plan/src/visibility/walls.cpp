#include "visibility/walls.h"

#include <algorithm>
#include <cmath>

namespace tyndall {
namespace {

struct Candidate {
    std::size_t blocker = 0;
    glm::dvec4 plane{0.0};  ///< light space, the lamp on its positive side
};
using Candidates = InlineVector<Candidate, mostWalls>;

// Light-space half spaces of the pyramid's sides and far end.
std::array<glm::dvec4, 5> pyramidPlanes(const Light& light) {
    const glm::dvec2 slope = glm::tan(0.5 * light.fov);
    return {unitPlane({1.0, 0.0, -slope.x, 0.0}), unitPlane({-1.0, 0.0, -slope.x, 0.0}),
            unitPlane({0.0, 1.0, -slope.y, 0.0}), unitPlane({0.0, -1.0, -slope.y, 0.0}),
            glm::dvec4{0.0, 0.0, 1.0, light.farPlane}};
}

double farthestInside(const glm::dvec4& plane, const Light& light, double axis, double sign) {
    const glm::dvec2 slope = glm::tan(0.5 * light.fov);
    double most = -1e300;
    for (int corner = 0; corner < 4; ++corner)
        most =
            std::max(most, sign * glm::dot(plane, glm::dvec4(axis * glm::dvec3((corner & 1) ? slope.x : -slope.x,
                                                                               (corner & 2) ? slope.y : -slope.y, -1.0),
                                                             1.0)));
    return most;
}

// Over the square of the distance along the axis, by how much a shadow map holds a plane of light space to be too near.
//
// With p = z (s, -1) for slopes s, a plane n p + D = 0 has z = D / (n.z - n.xy s), so dz / ds = z^2 n.xy / D.
// Filtering reads the four nearest texels, whose centres lie up to a texel aside both ways.
double mapError(const glm::dvec4& plane, const Light& light, std::uint32_t mapSize) {
    const glm::dvec2 texel = 2.0 * glm::tan(0.5 * light.fov) / static_cast<double>(mapSize);
    return glm::dot(glm::abs(glm::dvec2(plane)), texel) / plane.w;
}

// The bias that keeps a wall's shadow off the air before it lets every shadow of the light begin so much farther from
// the lamp than it ought to, a share of the distance. A wall that asks for more is steep to the light, and is an
// occluder like any other.
constexpr double mostMapError = 1.0 / 200.0;

bool steep(const glm::dvec4& plane, const Light& light, std::uint32_t mapSize) {
    const glm::dvec2 slope = glm::tan(0.5 * light.fov);
    const double grazing = plane.z - glm::dot(glm::abs(glm::dvec2(plane)), slope);
    const double farthest = grazing * light.farPlane > plane.w ? plane.w / grazing : light.farPlane;
    return mapError(plane, light, mapSize) * farthest > mostMapError;
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

// Blockers whose plane crosses the pyramid beyond its near end, largest first.
Candidates candidatesFor(const Light& light, const View& view, std::span<const BlockerBounds> bounds,
                         std::uint32_t mapSize) {
    const glm::dvec3 lamp(light.worldFromLight[3]);
    const std::array<glm::dvec3, 4> picture = nearCorners(view);
    const glm::dmat3 lightFromWorld = glm::inverse(glm::dmat3(light.worldFromLight));
    const std::array<glm::dvec4, 5> sides = pyramidPlanes(light);
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
        // Relative to a point of the blocker: far from the origin, the plane's offset has lost its digits.
        double lampDistance = glm::dot(normal, lamp - blocker.centre);
        if (std::any_of(picture.begin(), picture.end(), [&](const glm::dvec3& corner) {
                return !(lampDistance * glm::dot(normal, corner - blocker.centre) > 0.0);
            }))
            continue;
        const double sign = lampDistance > 0.0 ? 1.0 : -1.0;
        lampDistance *= sign;
        const glm::dvec4 plane(sign * (lightFromWorld * normal), lampDistance);
        if (farthestInside(plane, light, light.nearPlane, -1.0) >= 0.0) continue;  // would cut the near end
        if (farthestInside(plane, light, light.farPlane, -1.0) <= 0.0) continue;   // beyond the far end
        if (steep(plane, light, mapSize)) continue;
        Candidate candidate{i, plane};
        if (found.size() < mostWalls) {
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

// Coordinates in which the plane is z = 0, so that slicePolygon() with depth 0 cuts in it.
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

// What lies outside of the triangle, in convex pieces.
void subtract(const SlicePolygon& whole, std::array<glm::dvec2, 3> triangle, std::vector<SlicePolygon>& left) {
    const auto turn = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
    if (turn(triangle[1] - triangle[0], triangle[2] - triangle[0]) < 0.0) std::swap(triangle[1], triangle[2]);
    SlicePolygon rest = whole;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 side = triangle[(i + 1) % 3] - triangle[i];
        const double length = glm::length(side);
        if (length == 0.0) return left.push_back(whole);  // no triangle
        const glm::dvec2 inward = glm::dvec2(-side.y, side.x) / length;
        const double offset = -glm::dot(inward, triangle[i]);
        SlicePolygon inside, outside;
        split(rest, inward, offset, inside, outside);
        if (outside.count >= 3) left.push_back(outside);
        if (inside.count < 3) return;
        rest = inside;
    }
}

// More pieces than this, and looking for the last crack costs more than drawing.
constexpr std::size_t mostPieces = 256;
// Of the face's diameter: how wide the cracks are at most that rounding leaves between triangles in 32-bit floats.
constexpr double crack = 1e-6;

// A piece's area over its length.
double width(const SlicePolygon& piece) {
    glm::dvec2 least(piece.corners[0]), most = least;
    for (std::size_t i = 1; i < piece.count; ++i) {
        least = glm::min(least, piece.corners[i]);
        most = glm::max(most, piece.corners[i]);
    }
    return area(piece) / glm::length(most - least);
}

bool covered(const Candidate& wall, const Candidates& walls, const Light& light, const Blocker& blocker,
             WallScratch& scratch, bool& touched) {
    const Frame frame = frameOf(wall.plane);
    InlineVector<glm::dvec4, 5 + mostWalls> planes;
    for (const glm::dvec4& plane : pyramidPlanes(light)) planes.push_back(inFrame(frame, plane));
    for (const Candidate& other : walls)
        if (other.blocker != wall.blocker) planes.push_back(inFrame(frame, other.plane));
    const double half = 4.0 * light.farPlane * glm::length(glm::dvec3(glm::tan(0.5 * light.fov), 1.0));
    const SlicePolygon face = slicePolygon(glm::dvec2(-half), glm::dvec2(half), {planes.data(), planes.size()}, 0.0);
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
        for (const SlicePolygon& piece : scratch.uncovered) subtract(piece, triangle, scratch.left);
        std::swap(scratch.left, scratch.uncovered);
        double widest = 0.0;
        for (const SlicePolygon& piece : scratch.uncovered) {
            if (piece.count == SlicePolygon::capacity) return false;  // corners may have been dropped
            widest = std::max(widest, width(piece));
        }
        if (widest <= crack * diameter) return true;
        if (scratch.uncovered.size() > mostPieces) return false;
    }
    return false;
}

}  // namespace

BlockerBounds boundsOf(const Blocker& blocker) {
    BlockerBounds bounds;
    glm::dvec3 normal(0.0);
    double largest = 0.0;
    for (const std::array<glm::dvec3, 3>& t : blocker.triangles) {
        const glm::dvec3 cross = glm::cross(t[1] - t[0], t[2] - t[0]);
        const double twice = glm::length(cross);
        bounds.area += 0.5 * twice;
        if (twice > largest) {
            largest = twice;
            normal = cross / twice;
            bounds.centre = t[0];
        }
    }
    if (!(bounds.area > 0.0)) return bounds;
    bounds.plane = glm::dvec4(normal, -glm::dot(normal, bounds.centre));
    for (const std::array<glm::dvec3, 3>& t : blocker.triangles)
        for (const glm::dvec3& corner : t)
            bounds.radius = std::max(bounds.radius, glm::distance(bounds.centre, corner));
    return bounds;
}

InlineVector<glm::dvec4, mostWalls> wallsOf(const Light& light, const View& view, const LightPose& pose,
                                            std::span<const Blocker> blockers, std::span<const BlockerBounds> bounds,
                                            std::uint32_t mapSize, WallScratch& scratch) {
    Candidates walls = candidatesFor(light, view, bounds, mapSize);
    // A wall that is not covered is none; without it the others' faces grow, and are looked at again.
    std::array<bool, mostWalls> touched{};
    for (bool changed = true; changed && !walls.empty();) {
        changed = false;
        for (std::size_t i = 0; i < walls.size() && !changed; ++i) {
            if (covered(walls[i], walls, light, blockers[walls[i].blocker], scratch, touched[i])) continue;
            Candidates kept;
            for (std::size_t k = 0; k < walls.size(); ++k)
                if (k != i) kept.push_back(walls[k]);
            walls = kept;
            changed = true;
        }
    }
    InlineVector<glm::dvec4, mostWalls> planes;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (!touched[i]) continue;  // the others keep the light from it
        const Candidate& wall = walls[i];
        const glm::dvec4 behind = wall.plane + glm::dvec4(0.0, 0.0, 0.0, wallMargin(wall.plane.w));
        planes.push_back(unitPlane(behind * pose.lightFromView));
    }
    return planes;
}

double mapErrorAt(std::span<const glm::dvec4> walls, const Light& light, const LightPose& pose, double axisLit,
                  std::uint32_t mapSize) {
    double most = 0.0;
    for (const glm::dvec4& wall : walls)
        most = std::max(most, mapError(unitPlane(wall * pose.viewFromLight), light, mapSize));
    return most * axisLit * axisLit;
}

}  // namespace tyndall

#include "occlusion.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tyndall::study {
namespace {

// Minimum distance between lamp and ray in the search for shadows, as a share of the maximum distance, so that ray and
// lamp span a plane. Edges move by at most that share. The plane's direction has an error from rounding as well; the
// square root of the precision of doubles makes both errors equal.
constexpr double minDistance = 1e-8;

double maxDistance(Span span) {
    return std::max(std::abs(span.begin), std::abs(span.end));
}

// The plane through lamp and ray: coordinates along the ray and across, from the lamp at the origin to the ray.
struct RayPlane {
    glm::dvec3 along, across, normal;
    double distance;
};

RayPlane rayPlane(const LightRay& ray, Span span) {
    const double min = minDistance * maxDistance(span);
    RayPlane plane{ray.direction, ray.foot, {}, ray.distance};
    if (plane.distance < min) {
        const glm::dvec3 d = glm::abs(ray.direction);
        const glm::dvec3 helper = d.x <= d.y && d.x <= d.z ? glm::dvec3(1, 0, 0)
                                  : d.y <= d.z             ? glm::dvec3(0, 1, 0)
                                                           : glm::dvec3(0, 0, 1);
        plane.across = glm::cross(ray.direction, helper);
        plane.distance = min;
    }
    plane.across = glm::normalize(plane.across);
    plane.normal = glm::cross(plane.along, plane.across);
    return plane;
}

// A piece of a straight line in the plane: (along, across) at both ends, and the axis distance there.
struct Piece {
    glm::dvec3 from, to;
};

// Keeps the part with a positive weighted sum of the three coordinates.
bool keep(Piece& piece, glm::dvec3 weight, double offset) {
    const double a = glm::dot(weight, piece.from) + offset, b = glm::dot(weight, piece.to) + offset;
    if (!(a > 0.0) && !(b > 0.0)) return false;
    if (a > 0.0 && b > 0.0) return true;
    const glm::dvec3 cut = piece.from + (piece.to - piece.from) * (a / (a - b));
    (a > 0.0 ? piece.to : piece.from) = cut;
    return true;
}

bool before(const glm::dvec3& a, const glm::dvec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

// The intersection of the triangle with the plane. Neighbours have bit-identical ends on their common edge: a corner in
// the plane counts to the same side for both, and an edge is always traversed in the same direction.
std::optional<Piece> cut(const RayPlane& plane, const Corners& corners) {
    std::array<double, 3> side;
    for (int i = 0; i < 3; ++i) side[i] = glm::dot(plane.normal, corners[i]);
    std::array<glm::dvec3, 2> ends;
    int count = 0;
    for (int i = 0; i < 3; ++i) {
        int from = i, to = (i + 1) % 3;
        if ((side[from] < 0.0) == (side[to] < 0.0)) continue;
        if (before(corners[to], corners[from])) std::swap(from, to);
        const glm::dvec3 p = corners[from] + (corners[to] - corners[from]) * (side[from] / (side[from] - side[to]));
        if (count < 2) ends[count++] = {glm::dot(plane.along, p), glm::dot(plane.across, p), -p.z};
    }
    if (count < 2) return std::nullopt;
    return Piece{ends[0], ends[1]};
}

// The stretch of the ray that the piece hides; may be empty.
Span shadowOf(Piece piece, const RayPlane& plane, double nearPlane, Span span) {
    // Between lamp and ray, beyond the near plane, inside the triangle of lamp and span.
    const double h = plane.distance;
    if (!keep(piece, {0.0, 0.0, 1.0}, -nearPlane) || !keep(piece, {0.0, -1.0, 0.0}, h) ||
        !keep(piece, {h, -span.begin, 0.0}, 0.0) || !keep(piece, {-h, span.end, 0.0}, 0.0))
        return {};
    const auto onRay = [&](const glm::dvec3& p) { return std::clamp(p.x * h / p.y, span.begin, span.end); };
    const double from = onRay(piece.from), to = onRay(piece.to);
    return {std::min(from, to), std::max(from, to)};
}

std::array<HalfSpace, 5> wedge(const RayPlane& plane, Span span, double farthest) {
    const double h = plane.distance, slack = 1e-12 * farthest;
    return {{
        {plane.normal, slack},
        {-plane.normal, slack},
        {-plane.across, h + slack},
        {glm::normalize(h * plane.along - span.begin * plane.across), slack},
        {glm::normalize(-h * plane.along + span.end * plane.across), slack},
    }};
}

}  // namespace

TriangleTree occluders(const Light& light, const std::vector<Triangle>& triangles) {
    const glm::dmat3 lightFromWorld = glm::transpose(glm::dmat3(light.worldFromLight));
    const glm::dvec3 lamp(light.worldFromLight[3]);
    const glm::dvec2 slope = tanHalfFovOf(light);
    const HalfSpace faces[] = {{{0.0, 0.0, -1.0}, -light.nearPlane}, {{0.0, 0.0, 1.0}, light.farPlane},
                               {{1.0, 0.0, -slope.x}, 0.0},          {{-1.0, 0.0, -slope.x}, 0.0},
                               {{0.0, 1.0, -slope.y}, 0.0},          {{0.0, -1.0, -slope.y}, 0.0}};
    std::vector<Corners> kept;
    for (const Triangle& triangle : triangles) {
        const Corners corners{lightFromWorld * (triangle.a - lamp), lightFromWorld * (triangle.b - lamp),
                              lightFromWorld * (triangle.c - lamp)};
        const bool out = std::any_of(std::begin(faces), std::end(faces), [&](const HalfSpace& face) {
            return std::all_of(corners.begin(), corners.end(),
                               [&](const glm::dvec3& p) { return glm::dot(face.normal, p) + face.offset < 0.0; });
        });
        if (!out) kept.push_back(corners);
    }
    return TriangleTree(std::move(kept));
}

void litSpans(std::vector<LitSpan>& lit, const TriangleTree& occluders, double nearPlane, const LightRay& ray,
              Span span) {
    if (span.empty()) return;
    const RayPlane plane = rayPlane(ray, span);
    const double farthest = plane.distance + maxDistance(span);
    thread_local std::vector<std::uint32_t> found;
    thread_local std::vector<Span> dark;
    found.clear();
    dark.clear();
    occluders.find(wedge(plane, span, farthest), found);
    for (const std::uint32_t index : found)
        if (const auto piece = cut(plane, occluders.triangles()[index]))
            if (const Span shadow = shadowOf(*piece, plane, nearPlane, span); !shadow.empty()) dark.push_back(shadow);

    std::sort(dark.begin(), dark.end(), [](const Span& a, const Span& b) { return a.begin < b.begin; });
    // A lit gap between shadows whose edges differ by rounding only is removed: a closed surface must not leak light at
    // its joints or at the ends of the span.
    const double joint = 4.0 * edgeError(ray, span);
    double open = span.begin;
    for (const Span& shadow : dark) {
        if (open + joint < shadow.begin) lit.push_back({{open, shadow.begin}});
        open = std::max(open, shadow.end);
    }
    if (open + joint < span.end || dark.empty()) lit.push_back({{open, span.end}});
}

double edgeError(const LightRay& ray, Span span) {
    const double farthest = maxDistance(span), share = ray.distance / farthest;
    return farthest * (share < minDistance ? 2.0 * minDistance : 0x1p-52 / share);
}

}  // namespace tyndall::study

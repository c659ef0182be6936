#include "shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tyndall::study {
namespace {

void append(std::vector<LitSpan>& lit, Span span, const std::array<bool, 4>& corners) {
    if (span.empty()) return;
    const LitSpan next{span, corners};
    if (!lit.empty() && lit.back().full() && next.full() && lit.back().span.end == span.begin)
        lit.back().span.end = span.end;
    else if (corners != std::array<bool, 4>{})
        lit.push_back(next);
}

// One cell: split where a corner's comparison changes.
void appendCell(std::vector<LitSpan>& lit, const ShadowMap& map, const TexelPath& path, const LightRay& ray,
                Span span) {
    const Cell cell(map.stored, path, Address::Clamp, span.middle());
    std::array<double, 4> maxAxis;
    for (int i = 0; i < 4; ++i)
        maxAxis[i] = map.maxLitAxis[static_cast<std::size_t>(cell.row(i)) * map.stored.width + cell.column(i)];

    thread_local std::vector<double> places;
    places.assign(1, span.begin);
    for (const double r : maxAxis) {
        const double s = (r + ray.foot.z) / -ray.direction.z;  // axis(s) = r
        if (s > span.begin && s < span.end) places.push_back(s);
    }
    places.push_back(span.end);
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const Span piece{places[i], places[i + 1]};
        std::array<bool, 4> corners;
        for (int c = 0; c < 4; ++c) corners[c] = ray.axis(piece.middle()) <= maxAxis[c];
        append(lit, piece, corners);
    }
}

}  // namespace

ShadowMap shadowMap(const Light& light, Image stored, double bias) {
    // stored = n (f - a) / (a (f - n)), so a = n f / (n + stored (f - n)): the far plane for an empty texel (0), which
    // hides nothing. A full texel (1) hides everything.
    const double n = light.nearPlane, f = light.farPlane;
    ShadowMap map;
    map.maxLitAxis.reserve(stored.values.size());
    for (const float texel : stored.values) {
        const double depth = static_cast<double>(texel);
        map.maxLitAxis.push_back(depth < 1.0 ? n * f / (n + depth * (f - n)) + bias
                                             : -std::numeric_limits<double>::infinity());
    }
    map.stored = std::move(stored);
    return map;
}

void litSpans(std::vector<LitSpan>& lit, const ShadowMap& map, const TexelPath& path, const LightRay& ray, Span span) {
    thread_local std::vector<double> places;
    places.assign(1, span.begin);
    addCrossings(places, path, map.stored, Address::Clamp, span);
    places.push_back(span.end);
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i + 1 < places.size(); ++i) appendCell(lit, map, path, ray, {places[i], places[i + 1]});
}

}  // namespace tyndall::study

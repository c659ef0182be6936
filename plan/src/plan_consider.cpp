#include <cmath>
#include <limits>

#include "needs/brightness.h"
#include "shape/attenuation.h"
#include "shape/light_shape.h"
#include "visibility/pixel_size.h"
#include "plan_stages.h"

namespace tyndall {
namespace {

// Why a light adds nothing wherever it stands.
Verdict darkness(const Light& light, Look look) {
    if (light.colour == glm::dvec3(0.0)) return Verdict::Black;
    if (look == Look::Article) return Verdict::Drawn;  // has its own intensity, and no density
    if (light.density == 0.0) return Verdict::NoDensity;
    if (light.intensity == 0.0 && light.ambient == 0.0) return Verdict::NoStrength;
    return Verdict::Drawn;
}

TermVerdict verdictOf(bool asked, const PlanContext& context, bool Terms::*term) {
    if (context.technique) {
        if ((*context.technique).*term) return TermVerdict::Forced;
        return asked ? TermVerdict::Overruled : TermVerdict::NotAsked;
    }
    if (context.options.everything) return TermVerdict::Forced;
    return asked ? TermVerdict::Drawn : TermVerdict::NotAsked;
}

bool uniform(const FactorRange& range) {
    return range.min == range.max;
}

double strongest(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

// The finest that the light may be drawn with, as an angle seen from the lamp. Of the light alone and not of the view,
// or slabs would jump when what is seen of a cookie turns out uniform.
double detailOf(const Light& light, const LightSurvey& survey, const PlanOptions& options) {
    double detail = std::numeric_limits<double>::infinity();
    const double width = narrowness(shapeOf(light));
    if (light.cookie) detail = std::min(detail, width * (survey.cookie ? survey.cookie->detail : 1.0 / 64.0));
    if (light.noise) {
        const double repeats = std::max({1.0, std::fabs(light.noise->scale.x), std::fabs(light.noise->scale.y)});
        detail = std::min(detail, width / repeats * (survey.noise ? survey.noise->detail : 1.0 / 64.0));
    }
    if (light.shadow) detail = std::min(detail, width / options.shadowMapSize * 4.0);
    return detail;
}

// Metres that a rasterizer may move an edge of a slice, whose corners it rounds to 1/256 pixel: so much farther behind
// a wall slices end, or a pixel whose slice lies just before the wall would lose its light.
double snapping(const View& view, const PlanOptions& options, double farthest) {
    constexpr double diagonal = 1.4143 / 512.0;
    return diagonal * pixelSize(view, options.pictureHeight, farthest);
}

// Metres of air at the lamp's end whose light is half a display step.
double visibleSlab(const Light& light, const PlanOptions& options) {
    const double perMetre = light.density * strongest(light.colour) / (4.0 * 3.14159265358979) *
                            maxAttenuation(light);
    return perMetre > 0.0 ? 0.5 * options.displayStep / perMetre : 0.0;
}

}  // namespace

bool consider(const PlanContext& context, const Light& light, const LightSurvey& survey, PlannedLight& planned,
              Candidate& candidate, ConsiderScratch& scratch) {
    const auto& [view, options, surroundings, occluders, blockers, sides, technique] = context;
    const bool whole = options.everything;
    planned.verdict = darkness(light, options.look);
    if (planned.verdict != Verdict::Drawn && !whole) return false;
    candidate.pose = lightPose(light.worldFromLight, view.worldFromView);
    const LightPose& pose = candidate.pose;
    if (!whole) planned.verdict = hiddenAtAGlance(light, view, pose, {sides.data(), sides.size()});
    if (planned.verdict != Verdict::Drawn && !whole) return false;

    planned.noiseVerdict = verdictOf(light.noise.has_value(), context, &Terms::noise);
    planned.shadowVerdict = verdictOf(light.shadow, context, &Terms::shadow);
    planned.cookieVerdict = verdictOf(light.cookie, context, &Terms::cookie);

    // Behind a wall there is no light only where shadows are drawn. Quads have no clip distance to spare for them.
    InlineVector<glm::dvec4, maxWalls> walls;
    if (light.shadow && planned.shadowVerdict != TermVerdict::Overruled && options.geometry == Geometry::ExactPolygons)
        walls = wallsOf(light, view, pose, surroundings.blockers, blockers, options.shadowMapSize, scratch.walls);
    ConvexPolyhedron seen;
    InlineVector<glm::dvec4, 8> beam;
    if (light.cookie && survey.cookie && planned.cookieVerdict != TermVerdict::Overruled)
        beam = beamSides(light, pose, *survey.cookie);
    candidate.volume = lightVolume(light, view, pose, {walls.data(), walls.size()}, {beam.data(), beam.size()}, seen);
    LightVolume& volume = candidate.volume;
    const bool hasDepth = volume.farDepth > volume.nearDepth;
    planned.verdict = volume.hidden;
    if (planned.verdict != Verdict::Drawn && !(whole && hasDepth)) return false;
    planned.volumeNear = volume.axisNear;
    planned.volumeFar = volume.axisFar;
    planned.walls = static_cast<std::uint32_t>(volume.walls.size());
    const double moved = snapping(view, options, std::min(volume.farLit, volume.farShown));
    for (glm::dvec4& wall : volume.walls) wall.w += moved;

    if (planned.verdict == Verdict::Drawn) candidate.air = seenAir(seen, shapeOf(light), view, pose, surroundings.depth);
    const SeenAir& air = candidate.air;
    if (!air.any && !whole) planned.verdict = Verdict::BehindTiles;
    if (planned.verdict != Verdict::Drawn && !whole) return false;
    planned.seenNear = air.axisNear;
    planned.seenFar = air.axisFar;

    const bool physical = options.look == Look::Physical;
    if (air.any && physical) {
        candidate.cookie = cookieRange(light, air, survey.cookie);
        candidate.noise = noiseRange(light, survey.noise);
    }
    if (!whole && !technique && physical) {
        if (candidate.cookie.largest() == 0.0) planned.verdict = Verdict::DarkCookie;
        if (candidate.noise.largest() == 0.0) planned.verdict = Verdict::NoDust;
        if (planned.verdict != Verdict::Drawn) return false;
        if (light.cookie && uniform(candidate.cookie)) {
            planned.cookieVerdict = TermVerdict::Uniform;
            candidate.cookieFactor = candidate.cookie.middle();
        }
        if (light.noise && uniform(candidate.noise)) {
            planned.noiseVerdict = TermVerdict::Uniform;
            candidate.noiseFactor = candidate.noise.middle().x;
        }
    }

    candidate.shadowBias = std::max(options.shadowBias, mapErrorAt({walls.data(), walls.size()}, light, pose,
                                                                   volume.axisLit, options.shadowMapSize));
    candidate.shadow = {false, light.nearPlane, light.nearPlane, {}};
    if (light.shadow && !technique && air.any && surroundings.occluders) {
        candidate.shadow = shadowNeed(light, pose, air, {walls.data(), walls.size()}, occluders, options.shadowMapSize,
                                      scratch.shades);
        candidate.divisible = candidate.shadow.needed;
        if (!whole && !candidate.shadow.needed) planned.shadowVerdict = TermVerdict::NoOccluder;
    }
    planned.firstOccluder = whole ? light.nearPlane : candidate.shadow.firstOccluder;

    planned.noise = planned.noiseVerdict == TermVerdict::Drawn || planned.noiseVerdict == TermVerdict::Forced;
    planned.shadow = planned.shadowVerdict == TermVerdict::Drawn || planned.shadowVerdict == TermVerdict::Forced;
    planned.cookie = planned.cookieVerdict == TermVerdict::Drawn || planned.cookieVerdict == TermVerdict::Forced;
    candidate.slabs =
        slabsOf(light, view, options, pose, volume, detailOf(light, survey, options), visibleSlab(light, options));
    planned.brightest = std::numeric_limits<double>::infinity();
    if (physical && air.any) {
        candidate.base = brightestWithoutTerms(light, air, candidate.slabs);
        const double factor = candidate.cookie.largest() * candidate.noise.largest();
        if (std::isfinite(factor)) planned.brightest = candidate.base * factor;
    }
    planned.verdict = Verdict::Drawn;
    return true;
}

}  // namespace tyndall

#include <cmath>
#include <limits>

#include "needs/brightness.h"
#include "needs/scattering.h"
#include "plan_stages.h"
#include "raycast/outline.h"
#include "shape/attenuation.h"
#include "shape/light_shape.h"

namespace tyndall {
namespace {

// Why a light adds nothing in any view, or Drawn.
Verdict strengthVerdict(const Light& light, Look look) {
    if (light.colour == glm::dvec3(0.0)) return Verdict::Black;
    if (look == Look::Article) return Verdict::Drawn;  // it has its own intensity, and no density
    if (light.density == 0.0) return Verdict::NoDensity;
    if (light.intensity == 0.0 && light.ambient == 0.0) return Verdict::NoStrength;
    return Verdict::Drawn;
}

// The finest feature of the light's terms, as an angle seen from the lamp. It depends on the light alone: if it
// depended on the view, slabs would jump when the seen part of a cookie becomes uniform.
double detailOf(const Light& light, const LightSurvey& survey, const PlanOptions& options) {
    double detail = std::numeric_limits<double>::infinity();
    const double width = narrowness(shapeOf(light));
    if (light.cookie) detail = std::min(detail, width * (survey.cookie ? survey.cookie->detail : 1.0 / 64.0));
    if (light.noise) {
        const double repeats = std::max({1.0, std::fabs(light.noise->scale.x), std::fabs(light.noise->scale.y)});
        detail = std::min(detail, width / repeats * (survey.noise ? survey.noise->detail : 1.0 / 64.0));
    }
    // The width of the phase function's peak.
    if (light.anisotropy != 0.0) detail = std::min(detail, 1.0 - std::fabs(light.anisotropy));
    if (light.shadow) detail = std::min(detail, width / options.shadowMapSize * 4.0);
    return detail;
}

// Metres of air at the lamp's end whose light is half a display step.
double visibleSlab(const Light& light, const PlanOptions& options) {
    const double perMetre =
        light.density * greyOf(light) / (4.0 * 3.14159265358979) * maxAttenuation(light) * phasePeak(light);
    return perMetre > 0.0 ? 0.5 * options.displayStep / perMetre : 0.0;
}

// With PlanOptions::everything, or with a volume whose seen part is unknown, all of the picture: rays find out.
void outline(const PlanContext& context, Candidate& candidate, ConsiderScratch& scratch) {
    // Edges of the volume that are seen edge-on end abruptly: rounding must not cut off their pixels.
    constexpr double margin = 2e-3;
    candidate.firstCorner = static_cast<std::uint32_t>(scratch.outlines.size());
    if (context.options.everything || candidate.seen.verdict != Verdict::Drawn)
        appendPicture(scratch.outlines);
    else
        appendOutline(scratch.outlines, scratch.lit, context.view, margin);
    candidate.corners = static_cast<std::uint32_t>(scratch.outlines.size()) - candidate.firstCorner;
}

}  // namespace

bool consider(const PlanContext& context, const Light& light, const LightSurvey& survey, PlannedLight& planned,
              Candidate& candidate, ConsiderScratch& scratch) {
    const PlanOptions& options = context.options;
    const bool whole = options.everything;
    planned.verdict = strengthVerdict(light, options.look);
    if (planned.verdict != Verdict::Drawn && !whole) return false;

    const PerTerm<TermVerdict> asked = planned.verdicts = askedTerms(light, options);
    SeenLight& seen = candidate.seen = seenLight(context, light, survey, asked, scratch.lit, scratch.walls);
    planned.verdict = seen.verdict;
    planned.volumeNear = seen.volume.axisNear;
    planned.volumeFar = seen.volume.axisFar;
    planned.walls = static_cast<std::uint32_t>(seen.volume.walls.size());
    planned.seenNear = seen.air.axisNear;
    planned.seenFar = seen.air.axisFar;
    if (!seen.drawable(options)) return false;

    NeededTerms& needed = candidate.needed = neededTerms(context, light, survey, seen, asked, scratch.shadows);
    planned.verdict = needed.verdict;
    planned.verdicts = needed.verdicts;
    if (planned.verdict != Verdict::Drawn) return false;
    planned.terms = needed.terms();
    planned.firstOccluder = whole ? light.nearPlane : needed.shadow.firstOccluder;

    candidate.shadowBias = std::max(
        options.shadowBias, mapErrorAt(seen.walls, light, seen.pose, seen.volume.axisLit, options.shadowMapSize));
    candidate.slabs = slabsOf(light, context.view, options, seen.pose, seen.volume, detailOf(light, survey, options),
                              visibleSlab(light, options));
    if (options.method == Method::Raycast) outline(context, candidate, scratch);
    planned.brightest = std::numeric_limits<double>::infinity();
    if (options.look == Look::Physical && seen.air.any) {
        candidate.base = brightestWithoutTerms(light, seen.air, candidate.slabs);
        double factor = 1.0;
        for (const Term term : allTerms) factor *= needed.ranges[term].largest();
        if (std::isfinite(factor)) planned.brightest = candidate.base * factor;
    }
    return true;
}

}  // namespace tyndall

#include "needs/needed_terms.h"

#include "needs/scattering.h"

namespace tyndall {
namespace {

// The factor's bounds over the seen air; 1 for a light that does not ask for the term.
FactorRange rangeOf(Term term, const Light& light, const View& view, const SeenLight& seen, const LightSurvey& survey) {
    switch (term) {
        case Term::Noise:
            return noiseRange(light, survey.noise);
        case Term::Shadow:
            break;  // always from 0 to 1
        case Term::Cookie:
            return cookieRange(light, seen.air, survey.cookie);
        case Term::Scattering:
            return scatteringRange(light, view, seen.pose, seen.air);
    }
    return {};
}

// The verdict on a light whose term is 0 in all of the seen air.
Verdict zeroTermVerdict(Term term) {
    return term == Term::Noise ? Verdict::NoDust : term == Term::Cookie ? Verdict::DarkCookie : Verdict::Absorbed;
}

bool uniform(const FactorRange& range) {
    return range.min == range.max;
}

}  // namespace

PerTerm<TermVerdict> askedTerms(const Light& light, const PlanOptions& options) {
    // The published picture scatters evenly in clear air.
    const TermSet asked = options.look == Look::Article ? termsOf(light).without(Term::Scattering) : termsOf(light);
    PerTerm<TermVerdict> verdicts;
    for (const Term term : allTerms) {
        TermVerdict& verdict = verdicts[term];
        if (options.terms ? options.terms->contains(term) : options.everything)
            verdict = TermVerdict::Forced;
        else if (asked.contains(term))
            verdict = options.terms ? TermVerdict::Overruled : TermVerdict::Drawn;
    }
    return verdicts;
}

NeededTerms neededTerms(const PlanContext& context, const Light& light, const LightSurvey& survey,
                        const SeenLight& seen, const PerTerm<TermVerdict>& asked,
                        std::vector<OccluderShadow>& scratch) {
    const PlanOptions& options = context.options;
    const bool physical = options.look == Look::Physical;
    const bool chosen = !options.everything && !options.terms;
    NeededTerms needed;
    needed.verdicts = asked;
    if (seen.air.any && physical)
        for (const Term term : allTerms) needed.ranges[term] = rangeOf(term, light, context.view, seen, survey);
    if (chosen && physical) {
        for (const Term term : allTerms)
            if (needed.ranges[term].largest() == 0.0) {
                needed.verdict = zeroTermVerdict(term);
                return needed;
            }
        for (const Term term : allTerms) {
            const FactorRange& range = needed.ranges[term];
            if (asked[term] != TermVerdict::Drawn || !hasStandIn(term) || !uniform(range)) continue;
            needed.verdicts[term] = TermVerdict::Uniform;
            needed.standIns[term] = range.middle();
        }
    }

    needed.shadow = {false, light.nearPlane, light.nearPlane, {}};
    if (light.shadow && !options.terms && seen.air.any && context.surroundings.occluders) {
        needed.shadow = shadowNeed(light, seen.pose, seen.air, seen.walls, *context.surroundings.occluders,
                                   options.shadowMapSize, scratch);
        needed.divisible = needed.shadow.needed;
        if (!options.everything && !needed.shadow.needed) needed.verdicts[Term::Shadow] = TermVerdict::NoOccluder;
    }
    return needed;
}

}  // namespace tyndall

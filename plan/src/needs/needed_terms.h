// Which terms a light is drawn with, and what stands in for the others.
#pragma once

#include <tyndall/plan.h>

#include <vector>

#include "needs/needs.h"
#include "plan_context.h"
#include "slice_constants.h"
#include "visibility/seen_light.h"

namespace tyndall {

/// Whether a factor can take the term's place. A shadow is sharp: none can.
constexpr bool hasStandIn(Term term) {
    return term != Term::Shadow;
}

struct NeededTerms {
    Verdict verdict = Verdict::Drawn;  ///< why the terms leave no light
    PerTerm<TermVerdict> verdicts;
    PerTerm<FactorRange> ranges;  ///< of each term's factor over what is seen
    StandIns standIns;
    ShadowNeed shadow;
    bool divisible = false;  ///< into what `shadow` says may lie in shadow and the rest

    TermSet terms() const {
        TermSet drawn;
        for (const Term term : allTerms) drawn = drawn.with(term, isDrawn(verdicts[term]));
        return drawn;
    }
};

/// What the light and the options ask for, whatever the view sees.
PerTerm<TermVerdict> askedTerms(const Light& light, const PlanOptions& options);

/// What of `asked` the view calls for. `scratch`: working memory.
NeededTerms neededTerms(const PlanContext& context, const Light& light, const LightSurvey& survey,
                        const SeenLight& seen, const PerTerm<TermVerdict>& asked, std::vector<Shade>& scratch);

}  // namespace tyndall

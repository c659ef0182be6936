// Which terms a light is drawn with, and which factors replace the others.
#pragma once

#include <tyndall/plan.h>

#include <vector>

#include "needs/needs.h"
#include "needs/stand_ins.h"
#include "plan_context.h"
#include "visibility/seen_light.h"

namespace tyndall {

/// Whether a factor can replace the term. A shadow is sharp, so no factor can.
constexpr bool hasStandIn(Term term) {
    return term != Term::Shadow;
}

struct NeededTerms {
    Verdict verdict = Verdict::Drawn;  ///< why the terms leave no light, or Drawn
    PerTerm<TermVerdict> verdicts;
    PerTerm<FactorRange> ranges;  ///< of each term's factor over the seen air
    StandIns standIns;
    ShadowNeed shadow;
    bool divisible = false;  ///< into the air that may lie in shadow, see `shadow`, and the rest

    TermSet terms() const {
        TermSet drawn;
        for (const Term term : allTerms) drawn = drawn.with(term, isDrawn(verdicts[term]));
        return drawn;
    }
};

/// What the light and the options ask for, for any view.
PerTerm<TermVerdict> askedTerms(const Light& light, const PlanOptions& options);

/// The terms of `asked` that the view needs. `scratch`: working memory.
NeededTerms neededTerms(const PlanContext& context, const Light& light, const LightSurvey& survey,
                        const SeenLight& seen, const PerTerm<TermVerdict>& asked, std::vector<OccluderShadow>& scratch);

}  // namespace tyndall

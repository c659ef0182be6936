#include <algorithm>
#include <cmath>
#include <tuple>

#include "plan_stages.h"

namespace tyndall {
namespace {

// All omissions together may change a pixel by this share of a display step: after rounding, a pixel changes by one
// step at most, and mostly by none.
constexpr double budgetShare = 0.25;

}  // namespace

void leaveOutTheFaint(const PlanOptions& options, std::span<Candidate> candidates, std::span<PlannedLight> lights,
                      std::vector<Omission>& scratch) {
    scratch.clear();
    const double budget = budgetShare * options.displayStep;
    if (!(budget > 0.0) || options.everything || options.terms || options.look == Look::Article) return;
    const auto offer = [&](double error, std::size_t candidate, std::optional<Term> term) {
        if (error <= budget) scratch.push_back({error, static_cast<std::uint32_t>(candidate), term});  // not NaN
    };
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& candidate = candidates[i];
        const PlannedLight& planned = lights[candidate.light];
        offer(planned.brightest, i, std::nullopt);
        for (const Term term : allTerms) {
            if (!planned.terms.contains(term) || !hasStandIn(term)) continue;
            double change = candidate.base;
            for (const Term other : allTerms)
                if (other != term) change *= candidate.needed.ranges[other].largest();
            offer(change * candidate.needed.ranges[term].spread(), i, term);
        }
    }
    std::sort(scratch.begin(), scratch.end(), [](const Omission& a, const Omission& b) {
        return std::tie(a.error, a.candidate, a.term) < std::tie(b.error, b.candidate, b.term);
    });
    double spent = 0.0;
    for (const Omission& omission : scratch) {
        spent += omission.error;
        if (spent > budget) return;
        Candidate& candidate = candidates[omission.candidate];
        PlannedLight& planned = lights[candidate.light];
        if (!omission.term) {
            planned.verdict = Verdict::TooFaint;
            continue;
        }
        const Term term = *omission.term;
        planned.verdicts[term] = TermVerdict::Invisible;
        planned.terms = planned.terms.without(term);
        candidate.needed.standIns[term] = candidate.needed.ranges[term].middle();
    }
}

}  // namespace tyndall

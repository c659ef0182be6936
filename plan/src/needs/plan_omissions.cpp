#include <algorithm>
#include <cmath>
#include <tuple>

#include "plan_stages.h"

namespace tyndall {
namespace {

// Share of a display step that all omissions together may change a pixel by: what is rounded to the nearest step
// changes by one at most, and mostly by none.
constexpr double budgetShare = 0.25;

}  // namespace

void leaveOutTheFaint(const PlanOptions& options, std::span<Candidate> candidates, std::span<PlannedLight> lights,
                      std::vector<Omission>& scratch) {
    scratch.clear();
    const double budget = budgetShare * options.displayStep;
    if (!(budget > 0.0) || options.everything || options.technique || options.look == Look::Article) return;
    const auto offer = [&](double error, std::size_t candidate, Omission::Kind kind) {
        if (error <= budget) scratch.push_back({error, static_cast<std::uint32_t>(candidate), kind});  // not NaN
    };
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& candidate = candidates[i];
        const PlannedLight& planned = lights[candidate.light];
        offer(planned.brightest, i, Omission::Kind::Light);
        if (planned.noise)
            offer(candidate.base * candidate.cookie.largest() * candidate.noise.spread(), i, Omission::Kind::Noise);
        if (planned.cookie)
            offer(candidate.base * candidate.noise.largest() * candidate.cookie.spread(), i, Omission::Kind::Cookie);
    }
    std::sort(scratch.begin(), scratch.end(), [](const Omission& a, const Omission& b) {
        return std::tie(a.error, a.candidate, a.kind) < std::tie(b.error, b.candidate, b.kind);
    });
    double spent = 0.0;
    for (const Omission& omission : scratch) {
        spent += omission.error;
        if (spent > budget) return;
        Candidate& candidate = candidates[omission.candidate];
        PlannedLight& planned = lights[candidate.light];
        switch (omission.kind) {
            case Omission::Kind::Light:
                planned.verdict = Verdict::TooFaint;
                break;
            case Omission::Kind::Noise:
                planned.noiseVerdict = TermVerdict::Invisible;
                planned.noise = false;
                candidate.noiseFactor = candidate.noise.middle().x;
                break;
            case Omission::Kind::Cookie:
                planned.cookieVerdict = TermVerdict::Invisible;
                planned.cookie = false;
                candidate.cookieFactor = candidate.cookie.middle();
                break;
        }
    }
}

}  // namespace tyndall

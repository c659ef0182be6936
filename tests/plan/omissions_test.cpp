// Exactly those lights and terms are left out that are too faint to be seen.
#include <gtest/gtest.h>

#include "plan_scenes.h"
#include "plan_stages.h"

namespace tyndall {
namespace {

using namespace test;

struct Faint {
    std::vector<Candidate> candidates;
    std::vector<PlannedLight> lights;
    std::vector<Omission> scratch;
    PlanOptions options;

    // A light of that strength, whose cookie and noise lie between the given values.
    void add(double base, FactorRange cookie = {}, FactorRange noise = {}) {
        Candidate candidate{};
        candidate.light = static_cast<std::uint32_t>(lights.size());
        candidate.base = base;
        candidate.needed.ranges[Term::Cookie] = cookie;
        candidate.needed.ranges[Term::Noise] = noise;
        PlannedLight light;
        light.light = lights.size();
        light.brightest = base * std::max({cookie.max.x, cookie.max.y, cookie.max.z}) * noise.max.x;
        light.terms = TermSet().with(Term::Cookie, cookie.spread() > 0.0).with(Term::Noise, noise.spread() > 0.0);
        for (const Term term : allTerms)
            light.verdicts[term] = light.terms.contains(term) ? TermVerdict::Drawn : TermVerdict::NotAsked;
        candidates.push_back(candidate);
        lights.push_back(light);
    }
    void leaveOut(double step) {
        options.displayStep = step;
        leaveOutTheFaint(options, candidates, lights, scratch);
    }
};

FactorRange between01(double min, double max) {
    return {glm::dvec3(min), glm::dvec3(max)};
}

TEST(Omissions, StayUnderAQuarterStepTogether) {
    Random random(1);
    int lightsOut = 0, cookiesOut = 0, noiseOut = 0;
    for (int trial = 0; trial < 500; ++trial) {
        Faint faint;
        for (int i = 0; i < 40; ++i) {
            const auto range = [&] {
                const double a = between(random, 0.0, 1.0), b = a + std::exp(between(random, -8.0, 0.0));
                return random() % 2 ? between01(a, b) : FactorRange{};
            };
            faint.add(std::exp(between(random, -12.0, 0.0)), range(), range());
        }
        faint.leaveOut(0.01);
        // The largest change of a pixel that gets the maximum or the minimum of every light.
        double error = 0.0;
        for (std::size_t i = 0; i < faint.lights.size(); ++i) {
            const PlannedLight& light = faint.lights[i];
            const Candidate& candidate = faint.candidates[i];
            const FactorRange& cookies = candidate.needed.ranges[Term::Cookie];
            const FactorRange& noises = candidate.needed.ranges[Term::Noise];
            if (light.verdict == Verdict::TooFaint) {
                error += candidate.base * cookies.max.x * noises.max.x;
                ++lightsOut;
                continue;
            }
            const auto standIn = [&](Term term) {
                return light.verdicts[term] == TermVerdict::Invisible ? candidate.needed.standIns[term].x : -1.0;
            };
            const double cookie = standIn(Term::Cookie), noise = standIn(Term::Noise);
            cookiesOut += cookie >= 0.0;
            noiseOut += noise >= 0.0;
            double worst = 0.0;
            for (const double c : {cookies.min.x, cookies.max.x})
                for (const double n : {noises.min.x, noises.max.x})
                    worst = std::max(worst, std::fabs(c * n - (cookie < 0.0 ? c : cookie) * (noise < 0.0 ? n : noise)));
            error += candidate.base * worst;
        }
        EXPECT_LE(error, 0.25 * 0.01 * (1.0 + 1e-12));
    }
    EXPECT_GT(lightsOut, 1000);
    EXPECT_GT(cookiesOut, 100);
    EXPECT_GT(noiseOut, 100);
}

TEST(Omissions, BeginWithTheFaintest) {
    Faint faint;
    for (const double strength : {0.8, 0.1, 0.5, 0.3, 7.0}) faint.add(strength);
    faint.leaveOut(4.0);  // so that 1 may go: 0.1 + 0.3 + 0.5
    const Verdict expected[] = {Verdict::Drawn, Verdict::TooFaint, Verdict::TooFaint, Verdict::TooFaint,
                                Verdict::Drawn};
    for (int i = 0; i < 5; ++i) EXPECT_EQ(faint.lights[i].verdict, expected[i]) << i;
}

TEST(Omissions, OfEquallyFaintLightsTakeTheFirst) {
    Faint faint;
    for (int i = 0; i < 10; ++i) faint.add(0.4);
    faint.leaveOut(4.0);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(faint.lights[i].verdict, i < 2 ? Verdict::TooFaint : Verdict::Drawn) << i;
}

TEST(Omissions, PutTheMeanInATermsPlace) {
    Faint faint;
    faint.add(1.0, between01(0.4, 0.6), between01(2.0, 2.002));
    faint.leaveOut(0.01);  // noise: 0.6 * 0.001 is less than 0.0025; cookie: 2 * 0.1 is not
    EXPECT_EQ(faint.lights[0].verdicts[Term::Noise], TermVerdict::Invisible);
    EXPECT_FALSE(faint.lights[0].terms.contains(Term::Noise));
    EXPECT_DOUBLE_EQ(faint.candidates[0].needed.standIns[Term::Noise].x, 2.001);
    EXPECT_EQ(faint.lights[0].verdicts[Term::Cookie], TermVerdict::Drawn);
    EXPECT_TRUE(faint.lights[0].terms.contains(Term::Cookie));
}

TEST(Omissions, AreNoneWhereNothingMayBeLeftOut) {
    const auto untouched = [](Faint& faint) {
        faint.add(1e-30, between01(0.4, 0.6), between01(0.0, 1.0));
        faint.leaveOut(faint.options.displayStep);
        return faint.lights[0].verdict == Verdict::Drawn && faint.lights[0].terms.contains(Term::Cookie) &&
               faint.lights[0].terms.contains(Term::Noise);
    };
    Faint step;
    EXPECT_TRUE(untouched(step)) << "no display step is known";
    Faint everything;
    everything.options.displayStep = 0.1;
    everything.options.everything = true;
    EXPECT_TRUE(untouched(everything));
    Faint technique;
    technique.options.displayStep = 0.1;
    technique.options.terms = TermSet::all();
    EXPECT_TRUE(untouched(technique));
    Faint article;
    article.options.displayStep = 0.1;
    article.options.look = Look::Article;
    EXPECT_TRUE(untouched(article));
    Faint unknown;
    unknown.options.displayStep = 0.1;
    unknown.add(0.0, {glm::dvec3(0.0), glm::dvec3(std::numeric_limits<double>::infinity())});
    unknown.leaveOut(0.1);  // 0 * infinity is NaN
    EXPECT_TRUE(unknown.lights[0].terms.contains(Term::Cookie));
}

}  // namespace
}  // namespace tyndall

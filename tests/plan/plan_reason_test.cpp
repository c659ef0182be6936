// The technique of a light, and the plan's explanation.
#include <gtest/gtest.h>

#include <set>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

TEST(Technique, IsNamedAfterExactlyItsTerms) {
    std::set<std::string_view> names;
    for (const TermSet terms : allTermSets) {
        std::string expected = "clip";
        for (const Term term : allTerms)
            if (terms.contains(term) || term != Term::Scattering)  // the published names lack it
                expected += (terms.contains(term) ? "_" : "_no") + std::string(nameOf(term));
        EXPECT_EQ(techniqueName(terms), expected + "_technique");
        EXPECT_EQ(termsOf(techniqueName(terms)), terms);
        names.insert(techniqueName(terms));
    }
    EXPECT_EQ(names.size(), TermSet::count);
    for (const std::string_view other : {"", "ps_main", "clip_noise_shadow_cookie"}) EXPECT_FALSE(termsOf(other));
}

TEST(Technique, IsWhatTheLightCallsFor) {
    Random random(1);
    Scene scene = randomScene(random);
    for (const TermSet terms : allTermSets) {
        const Light light = withTerms(scene.light, terms);
        EXPECT_EQ(termsOf(light), terms);
        EXPECT_EQ(planned({light}, scene.view, slices(4)).lights[0].terms, terms);
    }
}

TEST(Technique, CanBeForced) {
    Random random(2);
    Scene scene = randomScene(random);
    PlanOptions options = slices(4);
    options.terms = TermSet::all();
    const Plan result = planned({scene.light}, scene.view, options);
    EXPECT_EQ(result.lights[0].terms, TermSet::all());
    EXPECT_EQ(reason(result.lights[0], scene.view), "The options force this technique.");
    options.terms = TermSet{};
    scene.light.shadow = true;
    const PlannedLight light = planned({scene.light}, scene.view, options).lights[0];
    EXPECT_EQ(light.verdicts[Term::Shadow], TermVerdict::Overruled);
    EXPECT_EQ(savings(light), std::vector<std::string>{"No shadow: the options leave it out."});
}

TEST(Reason, TellsWhatIsSpared) {
    Random random(3);
    Scene scene = randomScene(random);
    const auto why = [&] { return reason(planned({scene.light}, scene.view, slices(4)).lights[0], scene.view); };
    EXPECT_EQ(why(), "The view needs none of noise, shadow, cookie and scattering.");
    scene.light.cookie = true;
    EXPECT_EQ(why(), "The view needs cookie, but not noise, shadow and scattering.");
    scene.light.shadow = true;
    EXPECT_EQ(why(), "The view needs shadow and cookie, but not noise and scattering.");
    scene.light.noise = Noise{};
    EXPECT_EQ(why(), "The view needs noise, shadow and cookie, but not scattering.");
}

struct UndrawnCase {
    const char* word;  // in the reason
    void (*change)(Scene&);
};

TEST(Reason, TellsWhyNothingIsDrawn) {
    const UndrawnCase cases[] = {
        {"black", [](Scene& s) { s.light.colour = glm::dvec3(0.0); }},
        {"density", [](Scene& s) { s.light.density = 0.0; }},
        {"intensity", [](Scene& s) { s.light.intensity = 0.0; }},
        {"clip planes",
         [](Scene& s) {
             s.light.clipPlanes = {{0, 1, 0, -1000}};
         }},
        {"behind the eye", [](Scene& s) { s.light.worldFromLight[3] += s.view.worldFromView[2] * 100.0; }},
        {"near plane at 100 m", [](Scene& s) { s.view.nearPlane = 100.0; }},
        {"far plane at 0.02 m", [](Scene& s) { s.view.farPlane = 0.02; }},
        {"surface at 0.02 m", [](Scene& s) { s.view.sceneDepth = 0.02; }},
        {"sideways", [](Scene& s) { s.light.worldFromLight[3] += s.view.worldFromView[0] * 100.0; }},
    };
    for (const UndrawnCase& c : cases)
        for (const Geometry geometry : {Geometry::ExactPolygons, Geometry::StretchedQuads}) {
            Random random(4);
            Scene scene = randomScene(random);
            c.change(scene);
            PlanOptions options = slices(4);
            options.geometry = geometry;
            const Plan result = planned({scene.light}, scene.view, options);
            ASSERT_EQ(result.lights.size(), 1u);
            const PlannedLight& light = result.lights[0];
            EXPECT_FALSE(light.drawn) << c.word;
            EXPECT_NE(reason(light, scene.view).find(c.word), std::string::npos) << reason(light, scene.view);
            EXPECT_EQ(light.slices, 0);
            EXPECT_EQ(light.indexCount, 0u);
            EXPECT_TRUE(result.vertices.empty() && result.indices.empty() && result.groups.empty());
        }
}

TEST(Reason, AmbientAloneIsEnoughToBeDrawn) {
    Random random(5);
    Scene scene = randomScene(random);
    scene.light.intensity = 0.0;
    scene.light.ambient = 1.0;
    EXPECT_TRUE(planned({scene.light}, scene.view, slices(4)).lights[0].drawn);
    scene.light.ambient = 0.0;
    scene.light.density = 0.0;
    PlanOptions options = slices(4);
    options.look = Look::Article;  // has its own
    EXPECT_TRUE(planned({scene.light}, scene.view, options).lights[0].drawn);
}

}  // namespace
}  // namespace tyndall

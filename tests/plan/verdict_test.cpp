// Every verdict, in a scene that causes it, and its sentence.
#include <gtest/gtest.h>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

TextureSurvey uniformSurvey(float value, bool wraps = false) {
    const std::vector<glm::vec4> texels(16, glm::vec4(value));
    return surveyTexture(4, 4, texels, wraps);
}

TextureSurvey patterned(float min, float max, bool wraps = false) {
    std::vector<glm::vec4> texels;
    for (int i = 0; i < 64 * 64; ++i) texels.push_back(glm::vec4((i / 64 + i) % 2 ? min : max));
    return surveyTexture(64, 64, texels, wraps);
}

// A projector at the origin that looks along -Z; the eye stands 6 m to its right and looks at it at an angle.
struct Case {
    Light light = projector();
    View view = perspectiveView(lookingAt({6.0, 0.5, -1.0}, {0.0, 0.0, -3.0}), 1.0, 1.5, 0.1,
                                std::numeric_limits<double>::infinity());
    PlanOptions options = slices(20);
    std::optional<std::vector<OccluderBox>> occluders;
    std::vector<Blocker> blockers;
    std::vector<float> depth;  // a single tile's
    TextureSurvey cookie, noise;

    Plan plan() const {
        Surroundings surroundings;
        OccluderSet occluderSet;
        if (occluders) {
            occluderSet = OccluderSet::fromBoxes(*occluders).value();
            surroundings.occluders = &occluderSet;
        }
        const BlockerSet blockerSet = BlockerSet::fromBlockers(blockers).value();
        surroundings.blockers = &blockerSet;
        if (!depth.empty()) surroundings.depth = DepthTiles{1, 1, depth};
        const LightSurvey survey{cookie.columns ? &cookie : nullptr, noise.columns ? &noise : nullptr};
        surroundings.surveys = std::span(&survey, 1);
        Result<Plan> result = tyndall::plan(std::span(&light, 1), view, options, surroundings);
        EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().message);
        return result ? *std::move(result) : Plan{};
    }
    PlannedLight planned() const { return plan().lights.at(0); }
};

OccluderBox box(const glm::dvec3& centre, double half) {
    OccluderBox box;
    box.minimum = centre - half;
    box.maximum = centre + half;
    return box;
}

Blocker wallAt(double z, double half) {
    return {{{{{-half, -half, z}, {half, -half, z}, {half, half, z}}},
             {{{-half, -half, z}, {half, half, z}, {-half, half, z}}}}};
}

void expectUndrawn(const Case& c, Verdict verdict, const std::string& sentence) {
    const Plan plan = c.plan();
    const PlannedLight& light = plan.lights.at(0);
    EXPECT_EQ(light.verdict, verdict) << sentence;
    EXPECT_FALSE(light.drawn) << sentence;
    EXPECT_EQ(reason(light, c.view), sentence);
    EXPECT_TRUE(savings(light).empty());
    EXPECT_TRUE(plan.vertices.empty() && plan.indices.empty() && plan.parts.empty() && plan.groups.empty() &&
                plan.constants.empty())
        << sentence;
    Case everything = c;
    everything.options.everything = true;
    if (verdict == Verdict::BehindWalls || verdict >= Verdict::BehindTiles) {
        const PlannedLight forced = everything.planned();
        EXPECT_TRUE(forced.drawn) << sentence;
        EXPECT_EQ(forced.slices, 20) << sentence;
        EXPECT_EQ(forced.terms, TermSet::all()) << sentence;
        EXPECT_EQ(reason(forced, c.view), "The options force this technique.");
    }
}

TEST(Verdict, IsDrawnWhereNothingSpeaksAgainstIt) {
    const Case c;
    EXPECT_EQ(c.planned().verdict, Verdict::Drawn);
    EXPECT_TRUE(c.planned().drawn);
}

TEST(Verdict, BlackAndEmptyAndStrengthless) {
    Case c;
    c.light.colour = glm::dvec3(0.0);
    expectUndrawn(c, Verdict::Black, "Not drawn: its colour is black.");
    c = {};
    c.light.density = 0.0;
    expectUndrawn(c, Verdict::NoDensity, "Not drawn: its air has the density 0 and scatters nothing.");
    c = {};
    c.light.intensity = 0.0;
    expectUndrawn(c, Verdict::NoStrength, "Not drawn: its intensity and ambient are both 0.");
}

TEST(Verdict, OutOfView) {
    Case c;
    c.light.clipPlanes = {{0.0, 0.0, 1.0, 0.0}};
    expectUndrawn(c, Verdict::ClipPlanes, "Not drawn: its clip planes leave nothing of its volume.");
    c = {};
    c.view.worldFromView = lookingAt({6.0, 0.5, -1.0}, {12.0, 0.0, -3.0});
    expectUndrawn(c, Verdict::BehindEye, "Not drawn: its volume lies wholly behind the eye.");
    c = {};
    c.view.nearPlane = 20.0;
    expectUndrawn(c, Verdict::BeforeNear, "Not drawn: its volume ends before the view's near plane at 20 m.");
    c = {};
    c.view.farPlane = 0.5;
    expectUndrawn(c, Verdict::BeyondFar, "Not drawn: its volume begins beyond the view's far plane at 0.5 m.");
    c = {};
    c.view.sceneDepth = 0.5;
    expectUndrawn(c, Verdict::BehindScene,
                  "Not drawn: its volume begins behind the farthest visible surface at 0.5 m.");
    c = {};
    c.view.worldFromView = lookingAt({6.0, 0.5, -1.0}, {26.0, 0.0, -20.0});
    expectUndrawn(c, Verdict::BesideView, "Not drawn: its volume misses the view's frustum sideways.");
}

TEST(Verdict, Hidden) {
    Case c;
    c.light.shadow = true;
    c.blockers = {wallAt(-1.0, 9.0)};
    // Looks at the air behind the wall, from before the wall.
    c.view.worldFromView = lookingAt({3.0, 0.0, -0.5}, {1.0, 0.0, -4.0});
    c.light.fov = {1.2, 1.2};
    c.view.clipFromView = perspectiveView(glm::dmat4(1.0), 0.3, 1.0, 0.1, 100.0).clipFromView;
    expectUndrawn(c, Verdict::BehindWalls,
                  "Not drawn: the part of its volume in the view lies behind blockers that stop all its light.");
    c = {};
    c.depth = {1.0f};
    expectUndrawn(c, Verdict::BehindTiles, "Not drawn: surfaces hide all of its volume.");
}

TEST(Verdict, NothingToSee) {
    Case c;
    c.light.cookie = true;
    c.cookie = uniformSurvey(0.0f);
    expectUndrawn(c, Verdict::DarkCookie, "Not drawn: its cookie is black in all of its seen volume.");
    c = {};
    c.light.noise = Noise{};
    c.noise = uniformSurvey(0.0f, true);
    expectUndrawn(c, Verdict::NoDust, "Not drawn: its noise is 0 everywhere.");
    c = {};
    c.light.noise = Noise{};
    c.light.noise->gain = 0.0;
    expectUndrawn(c, Verdict::NoDust, "Not drawn: its noise is 0 everywhere.");
    c = {};
    c.light.intensity = 1e-6;
    c.options.displayStep = 1.0;
    EXPECT_EQ(c.planned().verdict, Verdict::TooFaint);
    EXPECT_NE(reason(c.planned(), c.view).find("too little for the display to show"), std::string::npos);
}

TEST(TermVerdict, NotAskedOrDrawn) {
    Case c;
    PlannedLight light = c.planned();
    EXPECT_EQ(light.verdicts[Term::Noise], TermVerdict::NotAsked);
    EXPECT_EQ(light.verdicts[Term::Shadow], TermVerdict::NotAsked);
    EXPECT_EQ(light.verdicts[Term::Cookie], TermVerdict::NotAsked);
    c.light.noise = Noise{};
    c.light.shadow = c.light.cookie = true;
    light = c.planned();  // there are no surveys of the textures
    EXPECT_EQ(light.verdicts[Term::Noise], TermVerdict::Drawn);
    EXPECT_EQ(light.verdicts[Term::Shadow], TermVerdict::Drawn);
    EXPECT_EQ(light.verdicts[Term::Cookie], TermVerdict::Drawn);
    EXPECT_EQ(light.terms, TermSet::all().without(Term::Scattering));
    EXPECT_TRUE(savings(light).empty());
}

TEST(TermVerdict, NoOccluder) {
    Case c;
    c.light.shadow = true;
    c.occluders.emplace();
    PlannedLight light = c.planned();
    EXPECT_EQ(light.verdicts[Term::Shadow], TermVerdict::NoOccluder);
    EXPECT_EQ(light.terms, TermSet{});
    EXPECT_EQ(savings(light),
              std::vector<std::string>{"No shadow map: nothing stands between the lamp and the air that is seen."});
    c.occluders = {box({0.0, 0.0, 3.0}, 0.5), box({3.0, 0.0, -3.0}, 0.5), box({0.0, 0.0, -8.0}, 0.5),
                   box({0.0, 0.0, -0.2}, 0.1)};
    EXPECT_EQ(c.planned().verdicts[Term::Shadow], TermVerdict::NoOccluder)
        << "behind, beside, beyond, before the near plane";
    c.occluders->push_back(box({0.0, 0.0, -4.0}, 0.5));
    light = c.planned();
    EXPECT_EQ(light.verdicts[Term::Shadow], TermVerdict::Drawn);
    EXPECT_NEAR(light.firstOccluder, 3.5, 1e-3);
    ASSERT_EQ(savings(light).size(), 1u);
    EXPECT_EQ(savings(light)[0],
              "Shadow looked up only where occluders can throw one, the first of them 3.5 m from the lamp.");
}

TEST(TermVerdict, Uniform) {
    Case c;
    c.light.cookie = true;
    c.light.noise = Noise{};
    c.light.noise->gain = 2.0;
    c.cookie = uniformSurvey(0.25f);
    c.noise = uniformSurvey(0.5f, true);
    const Plan plan = c.plan();  // although no display step is known
    const PlannedLight& light = plan.lights.at(0);
    EXPECT_EQ(light.verdicts[Term::Cookie], TermVerdict::Uniform);
    EXPECT_EQ(light.verdicts[Term::Noise], TermVerdict::Uniform);
    EXPECT_EQ(light.terms, TermSet{});
    EXPECT_EQ(savings(light).size(), 2u);
    Case plain = c;
    plain.light.cookie = false;
    plain.light.noise.reset();
    const glm::vec4 full = constantsOf(plain.plan(), 0).colour, quarter = constantsOf(plan, 0).colour;
    EXPECT_EQ(quarter.r, 0.25f * full.r);
    EXPECT_EQ(quarter.a, full.a);
    EXPECT_EQ(constantsOf(plan, 0).dust.x, 0.5f) << "2 * 0.5 * 0.5";
    EXPECT_NEAR(light.brightest, 0.125 * plain.planned().brightest, 1e-9);
}

TEST(TermVerdict, Invisible) {
    Case c;
    c.light.cookie = true;
    c.cookie = patterned(0.499f, 0.501f);
    c.options.displayStep = 1.0;
    c.light.intensity = 1000.0;
    PlannedLight light = c.planned();
    EXPECT_EQ(light.verdict, Verdict::Drawn);
    EXPECT_EQ(light.verdicts[Term::Cookie], TermVerdict::Invisible);
    EXPECT_EQ(savings(light),
              std::vector<std::string>{"No cookie: it differs by less than the display shows; its mean replaces it."});
    c.options.displayStep = 1e-9;
    EXPECT_EQ(c.planned().verdicts[Term::Cookie], TermVerdict::Drawn);
}

TEST(TermVerdict, ForcedAndOverruled) {
    Case c;
    c.light.shadow = true;
    c.light.cookie = true;
    c.occluders.emplace();
    c.cookie = uniformSurvey(1.0f);
    c.options.terms = TermSet{Term::Noise, Term::Cookie};
    const PlannedLight light = c.planned();
    EXPECT_EQ(light.verdicts[Term::Noise], TermVerdict::Forced);
    EXPECT_EQ(light.verdicts[Term::Shadow], TermVerdict::Overruled);
    EXPECT_EQ(light.verdicts[Term::Cookie], TermVerdict::Forced);
    EXPECT_EQ(light.terms, *c.options.terms);
    EXPECT_EQ(savings(light), std::vector<std::string>{"No shadow: the options leave it out."});
}

TEST(Savings, TellOfWallsAndOfWhatIsSeen) {
    Case c;
    c.light.shadow = true;
    c.blockers = {wallAt(-4.0, 9.0)};
    c.occluders.emplace();
    PlannedLight light = c.planned();
    EXPECT_EQ(light.walls, 1u);
    EXPECT_NEAR(light.seenFar, 4.0, 0.01);
    const std::vector<std::string> words = savings(light);
    ASSERT_EQ(words.size(), 3u);
    EXPECT_EQ(words[1], "Ends at a wall that stops all its light.");
    EXPECT_EQ(words[2], "Seen: 3.5 m of its 5.5 m along the axis, from 0.5 m to 4 m.");
}

// Without shadows light continues behind a wall, and the shader has no planes left to cut quads at it.
TEST(Savings, EndAtNoWallThatCannotBeDrawn) {
    Case c;
    c.light.shadow = true;
    c.blockers = {wallAt(-4.0, 9.0)};
    c.occluders = {box({0.0, 0.0, -5.0}, 1.0)};
    EXPECT_EQ(c.planned().walls, 1u);
    EXPECT_EQ(c.planned().verdicts[Term::Shadow], TermVerdict::NoOccluder);
    c.options.geometry = Geometry::StretchedQuads;
    EXPECT_EQ(c.planned().walls, 0u);
    EXPECT_EQ(c.planned().verdicts[Term::Shadow], TermVerdict::Drawn);
    c.options.geometry = Geometry::ExactPolygons;
    c.options.terms = TermSet{};
    EXPECT_EQ(c.planned().walls, 0u);
    EXPECT_NEAR(c.planned().seenFar, 6.0, 1e-6);
}

// Only if slices are really divided.
TEST(Savings, DoNotTellOfADivisionThatIsNotMade) {
    Case c;
    c.light.shadow = true;
    c.occluders = {box({0.0, 0.0, -4.0}, 0.5)};
    EXPECT_EQ(c.plan().parts.size(), 2u);
    EXPECT_EQ(savings(c.planned()).size(), 1u);
    c.options.geometry = Geometry::StretchedQuads;
    EXPECT_EQ(c.plan().parts.size(), 1u);
    EXPECT_TRUE(savings(c.planned()).empty());
    c.options.geometry = Geometry::ExactPolygons;
    c.occluders = {box({0.0, 0.0, -0.9}, 0.4)};  // so near and large that a division does not pay
    EXPECT_EQ(c.plan().parts.size(), 1u);
    EXPECT_TRUE(savings(c.planned()).empty());
}

}  // namespace
}  // namespace tyndall

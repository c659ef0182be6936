// Laws between permutations, for any picture: a term that masks nothing changes nothing, and a term that masks
// everything leaves nothing.
#include <cmath>
#include <utility>
#include <vector>

#include "draw.h"
#include "permutation.h"

namespace tyndall::test {
namespace {

struct LawCase : Permutation {
    bool article;  ///< the published constants
};

void PrintTo(const LawCase& one, std::ostream* out) {
    *out << one.name() << (one.article ? " with the article's constants" : " in physical units");
}

struct LawName {
    template <class Info>
    std::string operator()(const Info& info) const {
        return info.param.name() + (info.param.article ? "_article" : "");
    }
};

// Each law for every technique that has its term, in both looks.
class LawTest : public GpuTest, public testing::WithParamInterface<LawCase> {
protected:
    static Shot everyTerm() {
        Shot shot = sideView();
        shot.article = GetParam().article;
        return shot;
    }
    static Drawing drawIt(const Shot& shot, const DrawOptions& options = {}) {
        return draw(shot, optionsFor(GetParam(), options));
    }
};
class CookieLawTest : public LawTest {};
class ShadowLawTest : public LawTest {};
class NoiseLawTest : public LawTest {};
class ScatteringLawTest : public LawTest {};

std::vector<LawCase> having(TermSet terms = {}) {
    std::vector<LawCase> all;
    for (const Permutation& permutation : predictedPermutations())
        for (const bool article : {false, true})
            if ((permutation.terms & terms) == terms && (!article || permutation.drawsTheArticle()))
                all.push_back({permutation, article});
    return all;
}

INSTANTIATE_TEST_SUITE_P(SlicesFx, LawTest, testing::ValuesIn(having()), LawName());
INSTANTIATE_TEST_SUITE_P(SlicesFx, CookieLawTest, testing::ValuesIn(having({Term::Cookie})), LawName());
INSTANTIATE_TEST_SUITE_P(SlicesFx, ShadowLawTest, testing::ValuesIn(having({Term::Shadow})), LawName());
INSTANTIATE_TEST_SUITE_P(SlicesFx, NoiseLawTest, testing::ValuesIn(having({Term::Noise})), LawName());

INSTANTIATE_TEST_SUITE_P(SlicesFx, ScatteringLawTest, testing::ValuesIn(having({Term::Scattering})), LawName());

// The rounding of the factor 1 for g = 0 and no extinction, with e = 2^-24: 1 - |g| is 1 and so is the base, exactly;
// two divisions 5 e each, a root 9 e, three products 3 e, exp(-0) 6 e (3 ulp). And e of the total for each of 16
// additions in either picture. 28 + 32 = 60 e.
constexpr double evenScattering = 60.0 * kFloatEps;

// Two pictures that differ only by a factor of exactly 1.
void expectIdentical(const Drawing& a, const Drawing& b) {
    ASSERT_EQ(whyNotFinite(a.sum), "");
    ASSERT_EQ(whyNotFinite(b.sum), "");
    EXPECT_GT(litPixels(a.sum), 500);
    int different = 0;
    for (std::size_t i = 0; i < a.sum.pixels.size(); ++i) different += a.sum.pixels[i] != b.sum.pixels[i];
    EXPECT_EQ(different, 0) << "largest difference " << largestDifference(a.sum, b.sum);
}

void expectWithin(const Drawing& a, const Drawing& b, double relative) {
    ASSERT_EQ(whyNotFinite(a.sum), "");
    ASSERT_EQ(whyNotFinite(b.sum), "");
    EXPECT_GT(litPixels(a.sum), 500);
    double worst = 0.0;
    for (std::size_t i = 0; i < a.sum.pixels.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            const double x = static_cast<double>(a.sum.pixels[i][c]), y = static_cast<double>(b.sum.pixels[i][c]);
            if (x != y) worst = std::max(worst, std::abs(x - y) / std::max(std::abs(x), std::abs(y)));
        }
    EXPECT_LE(worst, relative);
}

void expectExactlyZero(const Shot& shot, const Permutation& permutation, const DrawOptions& options = {}) {
    const Drawing drawing = draw(shot, optionsFor(permutation, options));
    EXPECT_EQ(drawing.plan.lights.at(0).terms, permutation.terms);
    EXPECT_GT(drawing.counters.draws, 0u);
    int nonzero = 0;
    for (const auto& pixel : drawing.sum.pixels)
        for (const float value : pixel) nonzero += !(value == 0.0f);  // NaN counts
    EXPECT_EQ(nonzero, 0);
}

// Multiplying by 1.0 is exact, and so is interpolating between ones: (1 - t) + t rounds to 1.
TEST_P(CookieLawTest, WhiteCookieEqualsNoCookie) {
    Shot white = shotFor(GetParam(), everyTerm());
    white.cookieMap = constantTexture(4, 4, {1.0f, 1.0f, 1.0f, 1.0f});
    expectIdentical(drawIt(white), draw(withTerms(white, GetParam().terms.without(Term::Cookie))));
}

// Every comparison gives lit, and bilinear weights of four ones add up to exactly 1.
TEST_P(ShadowLawTest, EmptyShadowMapEqualsNoShadow) {
    Shot empty = shotFor(GetParam(), everyTerm());
    empty.shadowMap = constantTexture(32, 32, {0.0f});
    expectIdentical(drawIt(empty), draw(withTerms(empty, GetParam().terms.without(Term::Shadow))));
}

TEST_P(CookieLawTest, BlackCookieLeavesNothing) {
    Shot black = shotFor(GetParam(), everyTerm());
    black.cookieMap = constantTexture(4, 4, {0.0f, 0.0f, 0.0f, 1.0f});
    expectExactlyZero(black, GetParam());
}

TEST_P(ShadowLawTest, FullOcclusionLeavesNothing) {
    Shot blocked = shotFor(GetParam(), everyTerm());
    blocked.shadowMap = constantTexture(32, 32, {1.0f});
    blocked.shadowBias = 0.0;
    expectExactlyZero(blocked, GetParam());
}

/// Rounding may put air at either end of the light's volume beyond the depths that a map can hold; `by` puts all
/// of it there.
DrawOptions withDepthMoved(float by) {
    DrawOptions options;
    options.change = [by](Plan& plan) { plan.constants.at(0).shadow.x += by; };
    return options;
}

TEST_P(ShadowLawTest, AFullMapBlocksAirBeforeTheNearPlaneToo) {
    Shot blocked = shotFor(GetParam(), everyTerm());
    blocked.shadowMap = constantTexture(32, 32, {1.0f});
    expectExactlyZero(blocked, GetParam(), withDepthMoved(1.0f));
}

TEST_P(ShadowLawTest, AnEmptyMapBlocksNothingBeyondTheFarPlaneEither) {
    Shot empty = shotFor(GetParam(), everyTerm());
    empty.shadowMap = constantTexture(32, 32, {0.0f});
    expectIdentical(drawIt(empty, withDepthMoved(-1.0f)), drawIt(empty));
}

// A lamp that is turned by 180 degrees has all slices behind it, where the projection would repeat the beam.
TEST_P(LawTest, NothingBehindTheLamp) {
    DrawOptions options;
    options.change = [](Plan& plan) {
        glm::mat4 turned(1.0f);
        turned[0][0] = turned[2][2] = -1.0f;  // half a turn about y
        SliceConstants& constants = plan.constants.at(0);
        constants.lightFromView = turned * constants.lightFromView;
    };
    Shot shot = shotFor(GetParam(), everyTerm());
    shot.shadowMap = constantTexture(32, 32, {0.0f});
    expectExactlyZero(shot, GetParam(), options);
}

TEST_P(NoiseLawTest, ZeroNoiseLeavesNothing) {
    for (const auto& [red, green] : {std::pair{0.0f, 1.0f}, {1.0f, 0.0f}, {0.0f, 0.0f}}) {
        Shot still = shotFor(GetParam(), everyTerm());
        still.noiseMap = constantTexture(4, 4, {red, green});
        expectExactlyZero(still, GetParam());
    }
}

// 0.5 * 0.6 = 0.3, and 0.3 of the article's 0.05 is its 0.015 for even air. With e = 2^-24: gain, 0.6, 0.015 and two
// products 5 e, interpolating constants three times 2 e for each
// channel, the factor's way into the product 1 e; and 1 e of the total for each of 16 additions in either
// picture. 5 + 12 + 1 + 32 = 50 e.
TEST_P(NoiseLawTest, NoiseOfConstantProductEqualsNoNoiseAtTheInverseGain) {
    Shot even = shotFor(GetParam(), everyTerm());
    even.noiseMap = constantTexture(4, 4, {0.5f, 0.6f});
    even.light.noise->gain = 1.0 / 0.3;
    ASSERT_EQ(even.slices, 16);
    expectWithin(drawIt(even), draw(withTerms(even, GetParam().terms.without(Term::Noise))), 50.0 * kFloatEps);
}

// A map that is read only at the middle of texel (0, 0) equals a map with that value everywhere. 50 e as above; and
// coordinates, after a matrix, a scale, a phase and a division, are 16 e off the texel's middle, times 8 texels, times
// at most 0.6 / 0.4 of the value from one texel to the next: 192 e.
TEST_P(NoiseLawTest, EachMapHasAScaleAndAPhaseOfItsOwn) {
    const Shot shot = shotFor(GetParam(), everyTerm());
    const Texture& noise = shot.noiseMap;
    const double middle = 0.5 / noise.width;
    for (const int map : {0, 1}) {
        SCOPED_TRACE(map);
        DrawOptions still;
        still.change = [&](Plan& plan) {
            SliceConstants& constants = plan.constants.at(0);
            (map == 0 ? constants.noise1 : constants.noise2) = glm::vec4(0.0f, 0.0f, middle, middle);
        };
        Shot even = shot;
        even.noiseMap = makeTexture(noise.width, noise.height, 2, [&](int x, int y, int c) {
            return static_cast<double>(c == map ? noise.at(0, 0, c) : noise.at(x, y, c));
        });
        expectWithin(drawIt(shot, still), drawIt(even), (50.0 + 192.0) * kFloatEps);
    }
}

// A technique may be forced on a light without its terms; a missing texture then masks nothing.
TEST_P(LawTest, ForcedOnALightWithoutItsTermsItDrawsTheSame) {
    const Shot plain = withTerms(everyTerm(), {});
    DrawOptions forced;
    forced.terms = GetParam().terms;
    const Drawing drawing = drawIt(plain, forced);
    EXPECT_EQ(drawing.plan.lights.at(0).terms, GetParam().terms);
    if (GetParam().terms.contains(Term::Scattering))
        expectWithin(drawing, draw(plain), evenScattering);
    else
        expectIdentical(drawing, draw(plain));
}

// The phase function stays the same, and exp(-extinction * path) falls.
TEST_P(ScatteringLawTest, StrongerExtinctionIsDarkerEverywhere) {
    Shot shot = shotFor(GetParam(), everyTerm());
    Drawing before = drawIt(shot);
    for (const double albedo : {0.4, 0.1, 0.01}) {
        shot.light.albedo = albedo;
        Drawing after = drawIt(shot);
        ASSERT_EQ(whyNotFinite(after.sum), "");
        int brighter = 0, darker = 0;
        for (std::size_t i = 0; i < after.sum.pixels.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                brighter += after.sum.pixels[i][c] > before.sum.pixels[i][c];
                darker += after.sum.pixels[i][c] < 0.9f * before.sum.pixels[i][c];
            }
        EXPECT_EQ(brighter, 0) << albedo;
        EXPECT_GT(darker, 500) << albedo;
        before = std::move(after);
    }
}

// exp(-10^5) is 0 in floats and in doubles; the result must be 0, not NaN.
TEST_P(ScatteringLawTest, AirThatLetsNothingThroughIsBlack) {
    Shot shot = shotFor(GetParam(), everyTerm());
    DrawOptions thick;
    thick.change = [](Plan& plan) { plan.constants.at(0).scattering.y = 1e5f; };
    const Drawing drawing = drawIt(shot, thick);
    EXPECT_GT(drawing.counters.draws, 0u);
    EXPECT_EQ(whyNotFinite(drawing.sum), "");
    EXPECT_EQ(litPixels(drawing.sum), 0);
}

}  // namespace
}  // namespace tyndall::test

// Laws that hold for any picture by raycast, and need no reference.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "draw.h"
#include "scenes.h"

namespace tyndall::test {
namespace {

class RaycastLaw : public GpuTest {};

Drawing drawn(const Shot& shot) {
    DrawOptions options;
    options.method = Method::Raycast;
    return draw(shot, options);
}

// The largest difference, as a share of the brightest value.
double difference(const Drawing& a, const Drawing& b) {
    EXPECT_EQ(whyNotFinite(a.sum) + whyNotFinite(b.sum), "");
    EXPECT_GT(litPixels(a.sum), 500);
    float brightest = 0.0f;
    for (const auto& pixel : a.sum.pixels) brightest = std::max(brightest, *std::ranges::max_element(pixel));
    return largestDifference(a.sum, b.sum) / static_cast<double>(brightest);
}

int litIn(const Drawing& drawing) {
    int lit = 0;
    for (const auto& pixel : drawing.sum.pixels) lit += pixel != std::array<float, 4>{};
    return lit;
}

TEST_F(RaycastLaw, AWhiteCookieEqualsNoCookie) {
    Shot white = sideView();
    white.cookieMap = constantTexture(4, 4, {1.0f, 1.0f, 1.0f, 1.0f});
    EXPECT_LT(difference(drawn(white), drawn(withTerms(white, TermSet::all().without(Term::Cookie)))), 5e-5);
}

TEST_F(RaycastLaw, AnEmptyShadowMapEqualsNoShadow) {
    for (const TermSet terms : {TermSet{Term::Shadow}, TermSet::all()}) {
        Shot empty = withTerms(sideView(), terms);
        empty.shadowMap = constantTexture(32, 32, {0.0f});
        EXPECT_LT(difference(drawn(empty), drawn(withTerms(empty, terms.without(Term::Shadow)))), 1e-6);
    }
}

TEST_F(RaycastLaw, FullOcclusionLeavesNothing) {
    Shot blocked = sideView();
    blocked.shadowMap = constantTexture(32, 32, {1.0f});
    blocked.shadowBias = 0.0;
    EXPECT_EQ(litIn(drawn(blocked)), 0);
}

TEST_F(RaycastLaw, ABlackCookieLeavesNothing) {
    Shot black = sideView();
    black.cookieMap = constantTexture(4, 4, {0.0f, 0.0f, 0.0f, 1.0f});
    EXPECT_EQ(litIn(drawn(black)), 0);
}

TEST_F(RaycastLaw, ARigidMotionOfTheWorldChangesNothing) {
    const glm::dmat4 motion =
        glm::rotate(glm::translate(glm::dmat4(1.0), {40.0, -7.0, 12.0}), 2.1, glm::dvec3(0.3, 0.8, -0.5));
    EXPECT_LT(difference(drawn(sideView()), drawn(moved(sideView(), motion))), 2e-5);
}

// Two halves of a light, cut by a plane, add up to the whole.
TEST_F(RaycastLaw, TheHalvesOfALightAddUp) {
    const Drawing whole = drawn(sideView());
    Shot upper = sideView(), lower = sideView();
    upper.light.clipPlanes = {{0.3, 1.0, 0.2, -1.3}};
    lower.light.clipPlanes = {{-0.3, -1.0, -0.2, 1.3}};
    Drawing sum = drawn(upper);
    const Drawing other = drawn(lower);
    EXPECT_GT(litPixels(sum.sum), 100);
    EXPECT_GT(litPixels(other.sum), 100);
    for (std::size_t i = 0; i < sum.sum.pixels.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) sum.sum.pixels[i][c] += other.sum.pixels[i][c];
    EXPECT_LT(difference(whole, sum), 1e-4);
}

// A speckled part of the map forces the walk down to single cells there. Rays that do not cross it pass the same air in
// larger blocks before and after, and keep their value.
TEST_F(RaycastLaw, BlocksOfTheHierarchyChangeNothing) {
    Shot shot = withTerms(sideView(), {Term::Shadow});
    const Drawing skipped = drawn(shot);
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 64; ++x)
            if ((x + y) % 2)
                shot.shadowMap.texels[static_cast<std::size_t>(y) * 64 + x] =
                    static_cast<float>(storedShadowDepth(shot.light, 1.5));
    const Drawing walked = drawn(shot);
    int same = 0, changed = 0;
    for (std::size_t i = 0; i < skipped.sum.pixels.size(); ++i) {
        const float a = skipped.sum.pixels[i][0], b = walked.sum.pixels[i][0];
        if (a == 0.0f) continue;
        (std::abs(a - b) <= 2e-6f * a ? same : changed) += 1;
    }
    EXPECT_GT(same, 1000);
    EXPECT_GT(changed, 10);
}

}  // namespace
}  // namespace tyndall::test

// Things that must not change the picture: the number of slices, the division of the volume, the scene's position in
// the world.
#include <algorithm>
#include <cmath>

#include "draw.h"
#include "permutation.h"

namespace tyndall::test {
namespace {

class InvarianceTest : public GpuTest {};

double total(const Picture& picture) {
    double sum = 0.0;
    for (const auto& pixel : picture.pixels) sum += static_cast<double>(pixel[0]) + pixel[1] + pixel[2];
    return sum;
}

// The midpoint rule with slabs of length h errs by at most h V / 2 for an integrand of total variation V. Along a ray
// the plain lamp's light rises once from 0 and falls once to 0, so V is twice its maximum: the error is at most h times
// that, and two counts differ by at most the sum of their errors. The largest of the samples is not the maximum, but
// lies within a slab of it; there 1 / d^2 is less by a factor of (1 + slab / near)^2 at most.
TEST_F(InvarianceTest, BrightnessDoesNotDependOnTheNumberOfSlices) {
    Shot shot = withTerms(sideView(), {});
    const std::vector<int> counts{50, 100, 200};
    std::vector<Picture> pictures;
    std::vector<OracleImage> expected;
    for (const int count : counts) {
        shot.slices = count;
        pictures.push_back(draw(shot).sum);
        expected.push_back(oracle(shot));
        ASSERT_EQ(whyNotFinite(pictures.back()), "");
    }
    const double depths = expected[0].farDepth - expected[0].nearDepth;
    const double slant = 1.2;  // at least that of the picture's corner, tan^2(0.4) * 2 + 1 = 1.17^2
    const double missed = std::pow(1.0 + slant * depths / counts[0] / shot.light.nearPlane, 2.0);
    for (std::size_t k = 0; k + 1 < counts.size(); ++k) {
        SCOPED_TRACE(counts[k]);
        int apart = 0;
        for (std::size_t i = 0; i < pictures[k].pixels.size(); ++i) {
            double brightest = 0.0;  // per metre of depth
            for (std::size_t m = 0; m < counts.size(); ++m)
                brightest = std::max(brightest, expected[m].pixels[i].largest[0] * counts[m] / depths);
            const double coarse = pictures[k].pixels[i][0], fine = pictures[k + 1].pixels[i][0];
            const double slack = missed * brightest * (depths / counts[k] + depths / counts[k + 1]);
            apart += std::abs(coarse - fine) > slack;
        }
        EXPECT_EQ(apart, 0);
    }
    // Over a whole picture those errors have either sign; a viewer cannot see a difference of a hundredth.
    EXPECT_NEAR(total(pictures[0]) / total(pictures[2]), 1.0, 0.01);
    EXPECT_NEAR(total(pictures[1]) / total(pictures[2]), 1.0, 0.01);
}

// A clip plane perpendicular to the view direction, half way through the depths: the nearer eight slabs
// and the farther eight are those of the whole.
TEST_F(InvarianceTest, TwoHalvesAddUpToTheWhole) {
    for (const Geometry geometry : {Geometry::ExactPolygons, Geometry::StretchedQuads})
        for (const Permutation& permutation : predictedPermutations()) {
            SCOPED_TRACE(permutation.name());
            Shot whole = shotFor(permutation, sideView());
            whole.quads = geometry == Geometry::StretchedQuads;
            const OracleImage expected = oracle(whole);
            const glm::dvec3 back(whole.eye.worldFromView[2]);
            const glm::dvec3 eye(whole.eye.worldFromView[3]);
            const double middle = 0.5 * (expected.nearDepth + expected.farDepth);
            // In front of the plane: dot(back, p - eye) >= -middle.
            const glm::dvec4 nearer(back, middle - glm::dot(back, eye));

            Shot nearHalf = whole, farHalf = whole;
            nearHalf.slices = farHalf.slices = whole.slices / 2;
            nearHalf.light.clipPlanes = {nearer};
            farHalf.light.clipPlanes = {-nearer};
            DrawOptions options = optionsFor(permutation);
            options.geometry = geometry;
            const Drawing n = draw(nearHalf, options), f = draw(farHalf, options), w = draw(whole, options);
            EXPECT_NEAR(n.plan.lights[0].farDepth, middle, 1e-9);
            EXPECT_NEAR(f.plan.lights[0].nearDepth, middle, 1e-9);
            ASSERT_EQ(whyNotFinite(n.sum), "");
            ASSERT_EQ(whyNotFinite(f.sum), "");
            // Slabs as thick, at the same depths, to rounding: each drawing lies in the oracle's interval.
            int apart = 0;
            for (std::size_t i = 0; i < expected.pixels.size(); ++i)
                for (int c = 0; c < 4; ++c) {
                    const Interval& allowed = expected.pixels[i].rgba[c];
                    const double sum = static_cast<double>(n.sum.pixels[i][c]) + f.sum.pixels[i][c];
                    apart += std::abs(sum - w.sum.pixels[i][c]) > allowed.hi - allowed.lo || !allowed.contains(sum);
                }
            EXPECT_EQ(apart, 0);
            EXPECT_GT(total(n.sum), 0.1 * total(w.sum));
            EXPECT_GT(total(f.sum), 0.1 * total(w.sum));
        }
}

// A hundred kilometres out a binary32 counts in steps of 7.8 mm. The plan works in doubles relative to the eye, 1.5e-11
// m there, so the picture keeps within the interval that holds at the origin.
TEST_F(InvarianceTest, MovingTheWorldMovesNothing) {
    const glm::dmat4 motion = lookAlong({1e5, -3e4, 7e4}, {0.4, -0.2, 0.7}, 2.1);
    for (const NamedShot& named : shots()) {
        SCOPED_TRACE(named.name);
        const std::vector<Allowed> allowed = allowedBy(oracle(named.shot));
        const Drawing drawing = draw(moved(named.shot, motion));
        EXPECT_EQ(whyOutside(drawing.sum, drawing.plan.scale, allowed), "");
        EXPECT_GT(litPixels(drawing.sum), 500);
    }
}

// Without its own depth range the eye's roll about its axis only turns the picture; a lamp seen by an eye rolled by
// half a turn shows the picture turned by half a turn.
TEST_F(InvarianceTest, RollingTheEyeTurnsThePicture) {
    Shot upright = sideView(), rolled = sideView();
    const glm::dmat4 frame = upright.eye.worldFromView;
    rolled.eye.worldFromView = {-frame[0], -frame[1], frame[2], frame[3]};
    const OracleImage expected = oracle(upright);
    const Picture picture = draw(rolled).sum;
    Picture turned = picture;
    std::reverse(turned.pixels.begin(), turned.pixels.end());
    EXPECT_EQ(whyOutside(turned, 1.0, allowedBy(expected)), "");
}

TEST_F(InvarianceTest, TheSameShotGivesTheSameBits) {
    const Drawing a = draw(sideView()), b = draw(sideView());
    EXPECT_EQ(a.sum.pixels, b.sum.pixels);
}

}  // namespace
}  // namespace tyndall::test

// Each masking term by itself: the picture with it, divided by the picture without it, is the mask, projected by
// the oracle. It uses one slice at a time: with several, the quotient would be a mean of many masks.
#include <cmath>

#include "draw.h"
#include "judge.h"
#include "oracle_masks.h"

namespace tyndall::test {
namespace {

struct MaskCase {
    Permutation permutation;
    Term term;
    bool article;
};

void PrintTo(const MaskCase& one, std::ostream* out) {
    *out << nameOf(one.term) << " of " << one.permutation.name();
}

struct MaskName {
    template <class Info>
    std::string operator()(const Info& info) const {
        return info.param.permutation.name() + "_" + std::string(nameOf(info.param.term)) +
               (info.param.article ? "_article" : "_physical");
    }
};

std::vector<MaskCase> cases() {
    std::vector<MaskCase> all;
    for (const Permutation& permutation : predictedPermutations())
        for (const bool article : {false, true}) {
            if (article && !permutation.drawsTheArticle()) continue;
            for (const Term term : allTerms)
                if (permutation.terms.contains(term)) all.push_back({permutation, term, article});
        }
    return all;
}

class MaskTest : public GpuTest, public testing::WithParamInterface<MaskCase> {};

INSTANTIATE_TEST_SUITE_P(SlicesFx, MaskTest, testing::ValuesIn(cases()), MaskName());

/// The one slice in the middle of the volume, and in the middle of its nearer and farther two thirds.
std::vector<NamedShot> slicesOf(const MaskCase& one) {
    Shot shot = shotFor(one.permutation, sideView());
    shot.slices = 1;
    shot.article = one.article;
    const OracleImage whole = oracle(shot);
    const double third = (whole.farDepth - whole.nearDepth) / 3.0;
    Shot near = shot, far = shot;
    near.farthestSurface = whole.farDepth - third;
    far.eye.nearPlane = whole.nearDepth + third;
    return {{"near", near}, {"middle", shot}, {"far", far}};
}

/// A pixel that another term makes black gives no information about this term.
bool dark(const Picture& open, std::size_t pixel) {
    return open.pixels[pixel][0] == 0.0f || open.pixels[pixel][1] == 0.0f || open.pixels[pixel][2] == 0.0f;
}

TEST_P(MaskTest, IsTheQuotientOfThePictureWithItAndThePictureWithoutIt) {
    const MaskCase& one = GetParam();
    double min = INFINITY, max = 0.0;
    for (const NamedShot& named : slicesOf(one)) {
        SCOPED_TRACE(named.name);
        const Drawing masked = draw(named.shot, optionsFor(one.permutation));
        EXPECT_EQ(masked.plan.lights.at(0).terms, one.permutation.terms);
        const Drawing open = draw(without(named.shot, one.term));
        EXPECT_EQ(masked.counters.slicesDrawn, 1u);
        EXPECT_NE(open.plan.lights.at(0).terms, one.permutation.terms);
        ASSERT_EQ(whyNotFinite(masked.sum), "");
        ASSERT_EQ(whyNotFinite(open.sum), "");

        const auto expected = projectedMask(named.shot, one.term);
        const int width = named.shot.width, height = named.shot.height;
        Picture quotient{width, height, decltype(Picture::pixels)(expected.size())};
        std::vector<Allowed> allowed(expected.size());
        int pixels = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            if (!expected[i] || dark(open.sum, i)) continue;
            ++pixels;
            for (int c = 0; c < 3; ++c) {
                quotient.pixels[i][c] =
                    static_cast<float>(static_cast<double>(masked.sum.pixels[i][c]) / open.sum.pixels[i][c]);
                allowed[i][c] = rounded((*expected[i])[c]);  // the quotient is kept in binary32
                min = std::min(min, (*expected[i])[c].mid());
                max = std::max(max, (*expected[i])[c].mid());
            }
        }
        judgeOracle(one.permutation,
                    "mask of " + std::string(nameOf(one.term)) + ", " + named.name + " slice" +
                        (one.article ? ", article" : ""),
                    quotient, 1.0, allowed);
        // An unknown mask would prove nothing.
        EXPECT_GT(pixels, 300);
        EXPECT_LT(vagueness(allowed), 0.02);
    }
    EXPECT_LT(min, 0.7 * max);  // a constant mask would prove nothing
}

}  // namespace
}  // namespace tyndall::test

// The reference against an estimator that tests points only: random scenes, both modes.
#include <gtest/gtest.h>
#include <study/monte_carlo.h>

#include <cmath>

#include "study_scene.h"

namespace tyndall::test {
namespace {

using study::Mode;

struct Score {
    int values = 0;         // with an error to judge by
    double squares = 0.0;   // of the distances in standard errors
    double largest = 0.0;   // of them
    double sharpest = 1.0;  // relative standard error, the smallest
};

using MakeScene = study::ReferenceScene (*)(std::uint64_t seed, Mode mode);

Score compare(MakeScene make, Mode mode, std::uint64_t firstSeed, int scenes, int samples) {
    Score score;
    for (int i = 0; i < scenes; ++i) {
        const study::ReferenceScene scene = make(firstSeed + static_cast<std::uint64_t>(i), mode);
        const auto image = study::reference(scene);
        if (!image) throw std::runtime_error(image.error().message);
        for (const auto& [x, y] : {std::pair{4, 3}, {1, 1}, {7, 2}, {2, 5}}) {
            const auto estimate = study::monteCarlo(scene, x, y, samples, 77);
            if (!estimate) throw std::runtime_error(estimate.error().message);
            const glm::dvec3 exact = image->radiance[static_cast<std::size_t>(y) * scene.width + x];
            for (int c = 0; c < 3; ++c) {
                const double error = estimate->standardError[c];
                if (error == 0.0) {  // dark, or a sliver of light too thin for the points
                    EXPECT_EQ(estimate->mean[c], 0.0) << i << " " << x;
                    EXPECT_LT(exact[c], 1e-9) << i << " " << x;
                    continue;
                }
                const double z = (exact[c] - estimate->mean[c]) / error;
                EXPECT_LT(std::abs(z), 5.0) << "scene " << i << " pixel " << x << ", " << y << " channel " << c << ": "
                                            << exact[c] << " against " << estimate->mean[c];
                score.squares += z * z;
                score.largest = std::max(score.largest, std::abs(z));
                score.sharpest = std::min(score.sharpest, error / exact[c]);
                ++score.values;
            }
        }
    }
    return score;
}

class MonteCarloTest : public testing::TestWithParam<Mode> {};
INSTANTIATE_TEST_SUITE_P(Reference, MonteCarloTest, testing::Values(Mode::Ideal, Mode::Hardware),
                         [](const auto& mode) { return mode.param == Mode::Ideal ? "Ideal" : "Hardware"; });

// Distances in standard errors of 32 replicates follow Student's t of 31 degrees: 31/29 in the mean square, more
// than 5 once in fifty thousand. Channels and neighbouring pixels are correlated, so the bounds are wider.
void expectAgreement(const Score& score) {
    testing::Test::RecordProperty("values", score.values);
    testing::Test::RecordProperty("largest", std::to_string(score.largest));
    testing::Test::RecordProperty("sharpest", std::to_string(score.sharpest));
    testing::Test::RecordProperty("mean_square", std::to_string(score.squares / score.values));
    EXPECT_GT(score.values, 200);
    EXPECT_LT(score.sharpest, 2e-4);
    EXPECT_LT(score.squares / score.values, 1.6);
    EXPECT_GT(score.squares / score.values, 0.6);
}

TEST_P(MonteCarloTest, AgreesWithinItsConfidenceInterval) {
    expectAgreement(compare(randomScene, GetParam(), 100, 60, 16000));
}

TEST_P(MonteCarloTest, AgreesWhereAirScattersAndAbsorbs) {
    expectAgreement(compare(scatteringScene, GetParam(), 100, 60, 16000));
}

TEST_P(MonteCarloTest, ConvergesWithTheNumberOfSamples) {
    const study::ReferenceScene scene = randomScene(GetParam() == Mode::Ideal ? 104 : 101, GetParam());
    const auto few = study::monteCarlo(scene, 4, 3, 1000, 1), many = study::monteCarlo(scene, 4, 3, 64000, 1);
    ASSERT_TRUE(few && many);
    ASSERT_GT(few->standardError.r, 0.0);
    // Strata: a smooth part that falls with the number to the power 3/2, an edge in one stratum to the power 1.
    EXPECT_LT(many->standardError.r, few->standardError.r / 20.0);
}

}  // namespace
}  // namespace tyndall::test
